//! Stitching two disjoint hulls to one: the stitch phase of the slides, over half-edge meshes.
//!
//! A plane that touches both hulls is turned around them. In each of its positions it holds an edge between the hulls,
//! the bridge. It is turned about the bridge until it meets the next vertex of either hull. The plane then holds a face
//! of the joined hull, and the other edge of this face between the hulls is the next bridge. The faces make a band.
//! Band edges that belong to a hull cut off those of its faces that see the other hull. The faces beyond the cut are
//! kept, the faces inside are removed.
//!
//! Each turn looks at all neighbours of both ends of the bridge: the time is linear if few vertices have many edges.
//!
//! If the plane holds more than three vertices, the face is their polygon: it replaces faces of the hulls in that
//! plane.

use super::Contradiction;
use std::collections::{HashMap, HashSet};

use predicament_mesh::half_edge::{Face, HalfEdge, HalfEdgeMesh, IndexedFaces, MeshVertex};
use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use super::plane::{PlaneMethod, flat};
use super::scratch::NONE;

/// The number of vertices in a batch of queries.
const CHUNK: usize = 1024;
/// The marker of half-edges that are edges of stitching faces.
const CUT: u8 = 1;

/// A vertex of one of the two hulls.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Corner {
    part: usize,
    at: MeshVertex,
    vertex: Vertex,
}

/// The state of stitching two hulls.
struct Stitch<'s> {
    session: &'s dyn Predicates,
    parts: &'s mut [HalfEdgeMesh; 2],
}

/// The hull of two hulls. All vertices of the first hull come before those of the second. These two vertices are on a
/// line with nothing below it, in the projection to the xy plane.
///
/// # Errors
/// If an invariant does not hold; the error names it.
pub(super) fn stitched(
    session: &dyn Predicates,
    parts: &mut [HalfEdgeMesh; 2],
    touching: [Vertex; 2],
) -> Result<HalfEdgeMesh, Contradiction> {
    let mut stitch = Stitch { session, parts };
    let band = stitch.band(touching)?;
    stitch.cut(&band)?;
    let kept = [0, 1].map(|part| stitch.kept(part));
    stitch.joined(&band, &kept)
}

impl Stitch<'_> {
    /// The stitching faces, each counterclockwise as seen from outside.
    fn band(&self, touching: [Vertex; 2]) -> Result<Vec<Vec<Corner>>, Contradiction> {
        let first = self.first_bridge(touching)?;
        // A hull has fewer than twice as many faces as vertices.
        let most = 2 * self.parts.iter().map(HalfEdgeMesh::vertex_count).sum::<usize>();
        let mut band = Vec::new();
        let mut bridge = first;
        while band.len() < most {
            let face = self.face(bridge)?;
            let edges = face.iter().zip(face.iter().cycle().skip(1)).filter(|(a, b)| a.part != b.part);
            let [mut there, mut back] = [None, None];
            let mut count = 0;
            for (&a, &b) in edges {
                *(if a.part == 0 { &mut there } else { &mut back }) = Some([a, b]);
                count += 1;
            }
            let (Some(there), Some([x, y]), 2) = (there, back, count) else {
                return Err(Contradiction::TwoBridges);
            };
            if there != bridge {
                return Err(Contradiction::Turned);
            }
            band.push(face);
            bridge = [y, x];
            if bridge == first {
                return Ok(band);
            }
        }
        Err(Contradiction::Band)
    }

    /// A first bridge: an edge of the joined hull between its parts, in the vertical plane through two vertices. All
    /// vertices in that plane are queried.
    fn first_bridge(&self, [a, b]: [Vertex; 2]) -> Result<[Corner; 2], Contradiction> {
        let session = self.session;
        let mut here: Vec<Corner> = Vec::new();
        let mut signs = [Sign::Zero; CHUNK];
        for (part, mesh) in self.parts.iter().enumerate() {
            let corners: Vec<Corner> =
                mesh.vertices().map(|at| Corner { part, at, vertex: mesh.scene_vertex(at) }).collect();
            let (ends, others): (Vec<Corner>, Vec<Corner>) =
                corners.into_iter().partition(|corner| [a, b].contains(&corner.vertex));
            here.extend(ends);
            for chunk in others.chunks(CHUNK) {
                let vertices: Vec<Vertex> = chunk.iter().map(|corner| corner.vertex).collect();
                let signs = &mut signs[..chunk.len()];
                session.orient2d_line(Plane::Xy, [a, b], &vertices, signs);
                here.extend(
                    chunk.iter().zip(signs).filter(|(_, sign)| **sign == Sign::Zero).map(|(&corner, _)| corner),
                );
            }
        }
        // (These two differ in x: the second part has a volume to their right, and nothing of it is below their line.)
        let polygon = self.polygon(Plane::Zx, &here);
        let mut edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
        let bridge = edges.find_map(|(&a, &b)| match [a.part, b.part] {
            [0, 1] => Some([a, b]),
            [1, 0] => Some([b, a]),
            _ => None,
        });
        bridge.ok_or(Contradiction::Below)
    }

    /// The polygon of these corners, counterclockwise in a coordinate plane.
    fn polygon(&self, plane: Plane, corners: &[Corner]) -> Vec<Corner> {
        let vertices: Vec<Vertex> = corners.iter().map(|corner| corner.vertex).collect();
        let hull = flat(self.session, plane, PlaneMethod::Chain, &vertices);
        // Only looked up, never iterated: its order does not affect the output.
        let of: HashMap<Vertex, Corner> = corners.iter().map(|&corner| (corner.vertex, corner)).collect();
        hull.vertices.iter().filter_map(|v| of.get(v).copied()).collect()
    }

    /// The vertices that share an edge with this one.
    fn neighbours(&self, corner: Corner) -> impl Iterator<Item = Corner> + '_ {
        let mesh = &self.parts[corner.part];
        mesh.ring(corner.at).map(move |h| {
            let at = mesh.start(h);
            Corner { part: corner.part, at, vertex: mesh.scene_vertex(at) }
        })
    }

    /// The face of the joined hull on the left of an edge between its parts.
    fn face(&self, [u, v]: [Corner; 2]) -> Result<Vec<Corner>, Contradiction> {
        let session = self.session;
        let is_off_line = |w: Corner| {
            [Plane::Xy, Plane::Yz, Plane::Zx]
                .into_iter()
                .find(|&plane| session.orient2d(plane, u.vertex, v.vertex, w.vertex) != Sign::Zero)
        };
        let mut best: Option<Corner> = None;
        for w in self.neighbours(u).chain(self.neighbours(v)) {
            let is_better = match best {
                None => is_off_line(w).is_some(),
                Some(best) => session.orient3d(u.vertex, v.vertex, best.vertex, w.vertex) == Sign::Negative,
            };
            if is_better {
                best = Some(w);
            }
        }
        let best = best.ok_or(Contradiction::Bridge)?;
        let mut here = vec![u, v];
        let mut seen: HashSet<Vertex> = [u.vertex, v.vertex].into();
        let mut next = 0;
        while let Some(&corner) = here.get(next) {
            next += 1;
            for w in self.neighbours(corner) {
                if !seen.insert(w.vertex) {
                    continue;
                }
                let is_here = w == best
                    || match session.orient3d(u.vertex, v.vertex, best.vertex, w.vertex) {
                        Sign::Positive => false,
                        Sign::Zero => true,
                        Sign::Negative => return Err(Contradiction::Outside),
                    };
                if is_here {
                    here.push(w);
                }
            }
        }
        if here.len() == 3 {
            return Ok(vec![u, v, best]);
        }
        let plane = is_off_line(best).ok_or(Contradiction::Bridge)?;
        let mut polygon = self.polygon(plane, &here);
        if session.orient2d(plane, u.vertex, v.vertex, best.vertex) == Sign::Negative {
            polygon.reverse();
        }
        Ok(polygon)
    }

    /// Marks the half-edges of the parts that are edges of stitching faces.
    fn cut(&mut self, band: &[Vec<Corner>]) -> Result<(), Contradiction> {
        for face in band {
            for (a, b) in face.iter().zip(face.iter().cycle().skip(1)).filter(|(a, b)| a.part == b.part) {
                let mesh = &mut self.parts[a.part];
                let h = mesh.find(a.at, b.at).ok_or(Contradiction::Within)?;
                mesh.set_marker(h, CUT);
            }
        }
        Ok(())
    }

    /// For each face of a part, true if it is beyond the cut: a face of the joined hull.
    fn kept(&self, part: usize) -> Vec<bool> {
        let mesh = &self.parts[part];
        let mut kept = vec![false; mesh.face_count()];
        let beyond = |h: HalfEdge| {
            let opposite = mesh.opposite(h);
            mesh.face(opposite).filter(|_| mesh.marker(opposite) != CUT)
        };
        let mut found: Vec<Face> = mesh.half_edges().filter(|&h| mesh.marker(h) == CUT).filter_map(beyond).collect();
        while let Some(f) = found.pop() {
            if !std::mem::replace(&mut kept[f.index()], true) {
                found.extend(mesh.loop_of(mesh.half_edge_of_face(f)).filter_map(beyond));
            }
        }
        kept
    }

    /// The mesh of the kept faces and the stitching faces.
    fn joined(&self, band: &[Vec<Corner>], kept: &[Vec<bool>; 2]) -> Result<HalfEdgeMesh, Contradiction> {
        let mut places = [0, 1].map(|part: usize| vec![NONE; self.parts[part].vertex_count()]);
        let mut vertices: Vec<Vertex> = Vec::new();
        let mut faces = IndexedFaces::default();
        let mut place = |part: usize, at: MeshVertex| {
            let place = &mut places[part][at.index()];
            if *place == NONE {
                *place = u32::try_from(vertices.len()).unwrap_or(NONE);
                vertices.push(self.parts[part].scene_vertex(at));
            }
            *place
        };
        for (part, mesh) in self.parts.iter().enumerate() {
            for f in mesh.faces().filter(|f| kept[part][f.index()]) {
                faces.push(mesh.loop_of(mesh.half_edge_of_face(f)).map(|h| place(part, mesh.start(h))));
            }
        }
        for face in band {
            faces.push(face.iter().map(|corner| place(corner.part, corner.at)));
        }
        let mesh = HalfEdgeMesh::new(vertices, &faces).map_err(|_| Contradiction::Surface)?;
        if mesh.half_edges().any(|h| mesh.is_boundary(h)) {
            return Err(Contradiction::Closed);
        }
        Ok(mesh)
    }
}
