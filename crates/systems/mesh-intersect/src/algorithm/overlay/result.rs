//! The results of an overlay: Boolean operations, and the regions of both meshes together.

use crate::answer::{Regions, Source};
use predicament_mesh::OUTSIDE;
use predicament_mesh::half_edge::{ConversionError, HalfEdgeMesh, IndexedFaces};
use predicament_predicates::Vertex;
use rayon::prelude::*;

use super::{MeshOverlay, Piece, Shared};
use predicament_overlay::algorithm::overlay::Operation;

/// The number of triangles in one thread's work item.
const PART: usize = 32768;

/// A solid: a closed surface, counterclockwise as seen from outside.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Solid {
    /// The triangles, as input vertices and constructed ones.
    pub triangles: Vec<[Vertex; 3]>,
    /// For each triangle, its source: the triangle of a mesh that contains it.
    pub sources: Vec<Source>,
    /// For each triangle, true if it faces the other way than its source.
    pub turned: Vec<bool>,
}

impl Solid {
    /// Converts the result to a half-edge mesh with labels. A face's marker is its mesh, 0 or 1, and its user data the
    /// index of its triangle here, to be used with [`Solid::sources`] and [`Solid::turned`]. Vertices are the corners,
    /// ascending.
    ///
    /// # Errors
    /// [`ConversionError`] if four triangles share an edge, as along the curves of a symmetric difference, or where
    /// parts of an operand touch.
    pub fn half_edges(&self) -> Result<HalfEdgeMesh, ConversionError> {
        let mut vertices: Vec<Vertex> = self.triangles.as_flattened().to_vec();
        vertices.sort_unstable();
        vertices.dedup();
        let place = |v: &Vertex| super::near::number(vertices.partition_point(|other| other < v));
        let faces: IndexedFaces = self.triangles.iter().map(|triangle| triangle.iter().map(place)).collect();
        let mut mesh = HalfEdgeMesh::new(vertices, &faces)?;
        let faces: Vec<_> = mesh.faces().collect();
        for ((face, source), at) in faces.into_iter().zip(&self.sources).zip(0..) {
            mesh.set_face_marker(face, source.mesh);
            mesh.set_face_user_data(face, at);
        }
        Ok(mesh)
    }
}

impl MeshOverlay {
    /// The result of an operation on the insides of the meshes: all of their regions.
    ///
    /// Triangles of the first mesh come first, whole triangles before pieces, both in the order of the mesh. Parts of
    /// triangles of both meshes come last, with the first mesh's triangle as source.
    #[must_use]
    pub fn solid(&self, operation: Operation) -> Solid {
        let mut solid = Solid::default();
        for side in [0, 1] {
            let pieces = self.pieces(side);
            let take = |&Piece { triangle: [a, b, c], of, region }: &Piece| {
                let inside = |own: u32| {
                    let both = [own, region].map(|region| region != OUTSIDE);
                    operation.holds(if side == 0 { both } else { [both[1], both[0]] })
                };
                let [front, behind] = self.meshes[side].sides()[of as usize].map(inside);
                let source = Source { mesh: u8::from(side == 1), triangle: of };
                match [front, behind] {
                    [false, true] => Some(([a, b, c], (source, false))),
                    [true, false] => Some(([a, c, b], (source, true))),
                    _ => None,
                }
            };
            let whole = |part: usize| {
                let places = part * PART..self.whole[side].len().min((part + 1) * PART);
                let taken = places.filter_map(|place| self.whole_piece(side, place)).filter_map(|piece| take(&piece));
                taken.unzip::<_, _, Vec<_>, Vec<_>>()
            };
            let parts: Vec<_> = (0..self.whole[side].len().div_ceil(PART)).into_par_iter().map(whole).collect();
            for (triangles, labels) in parts {
                solid.triangles.extend(triangles);
                solid.sources.extend(labels.iter().map(|(source, _)| source));
                solid.turned.extend(labels.iter().map(|(_, is_turned)| is_turned));
            }
            for (triangle, (source, is_turned)) in pieces.iter().filter_map(take) {
                solid.triangles.push(triangle);
                solid.sources.push(source);
                solid.turned.push(is_turned);
            }
        }
        for shared in &self.shared {
            let inside = self.sides_of_shared(shared).map(|pair| operation.holds(pair.map(|region| region != OUTSIDE)));
            if inside[0] != inside[1] {
                let [a, b, c] = shared.triangle;
                solid.triangles.push(if inside[1] { [a, b, c] } else { [a, c, b] });
                solid.sources.push(Source { mesh: 0, triangle: shared.of[0] });
                solid.turned.push(inside[0]);
            }
        }
        solid
    }

    /// All triangles, with the pair of regions of both meshes on either side. The result has the triangles, the indices
    /// of the pairs in front and behind, and the list of pairs; the first pair is outside both.
    #[must_use]
    pub fn regions(&self) -> Regions {
        let mut pairs: Vec<[u32; 2]> = vec![[OUTSIDE; 2]];
        let all: Vec<(u8, Piece)> = [0_u8, 1]
            .into_iter()
            .flat_map(|side| {
                let at = usize::from(side);
                let whole = (0..self.whole[at].len()).filter_map(move |place| self.whole_piece(at, place));
                whole.chain(self.pieces(at).iter().copied()).map(move |piece| (side, piece))
            })
            .collect();
        let of = |(side, piece): &(u8, Piece)| {
            let pair = |own: u32| if *side == 0 { [own, piece.region] } else { [piece.region, own] };
            self.meshes[usize::from(*side)].sides()[piece.of as usize].map(pair)
        };
        pairs.extend(all.iter().flat_map(of));
        pairs.extend(self.shared.iter().flat_map(|shared| self.sides_of_shared(shared)));
        pairs.sort_unstable();
        pairs.dedup();
        let number = |pair: [u32; 2]| super::near::number(pairs.partition_point(|other| *other < pair));
        let shared = || self.shared.iter();
        Regions {
            triangles: all.iter().map(|(_, piece)| piece.triangle).chain(shared().map(|part| part.triangle)).collect(),
            sides: all
                .iter()
                .map(|one| of(one).map(number))
                .chain(shared().map(|part| self.sides_of_shared(part).map(number)))
                .collect(),
            sources: all
                .iter()
                .map(|&(mesh, piece)| Source { mesh, triangle: piece.of })
                .chain(shared().map(|part| Source { mesh: 0, triangle: part.of[0] }))
                .collect(),
            also: shared().map(|part| part.of[1]).collect(),
            pairs,
        }
    }

    /// The pair of regions of both meshes in front of a part of both, and behind it.
    pub(super) fn sides_of_shared(&self, shared: &Shared) -> [[u32; 2]; 2] {
        let [first, mut second] = [0, 1].map(|mesh: usize| self.meshes[mesh].sides()[shared.of[mesh] as usize]);
        if shared.is_turned {
            second.reverse();
        }
        [0, 1].map(|side: usize| [first[side], second[side]])
    }

    fn whole_piece(&self, side: usize, place: usize) -> Option<Piece> {
        let region = self.whole[side][place]?.get() - 1;
        let triangle = self.meshes[side].triangles()[place];
        Some(Piece { triangle, of: super::near::number(place), region })
    }
}
