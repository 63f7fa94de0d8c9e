//! Multi-material meshes: triangles with a region on either side.
//!
//! A closed surface is the simple case, with an inside and an outside. Regions that touch share triangles, so that no
//! point between them is in both or in neither.
//!
//! # What is refused
//! The boundary of a region is the chain of all triangles that have it on one side, each oriented with the region
//! behind it. If the chain uses each edge equally often in both directions, it is closed, and each point off it has a
//! winding number: all rays from a point give the same count. [`MaterialMesh::new`] refuses meshes that are not closed
//! in this sense: open surfaces, flipped triangles, and regions that contradict each other across an edge. Otherwise
//! surfaces may touch and cross themselves, and an edge may have any number of triangles.

use rayon::prelude::*;

use predicament_predicates::{Scene, Vertex};

use crate::length::longest;

/// The number of the region outside of everything.
pub const OUTSIDE: u32 = 0;

/// The reason why triangles with regions make no mesh.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum MaterialError {
    /// There are no triangles.
    Empty,
    /// A triangle has a vertex that the scene lacks.
    NoSuchVertex {
        /// The index of the triangle.
        triangle: usize,
        /// The vertex.
        vertex: Vertex,
    },
    /// A triangle has a vertex twice.
    Repeated {
        /// The index of the triangle.
        triangle: usize,
        /// The vertex.
        vertex: Vertex,
    },
    /// The boundary of a region is not closed at an edge.
    Open {
        /// The ends of the edge.
        edge: [Vertex; 2],
        /// The region.
        region: u32,
        /// A triangle at that edge with that region on one side.
        triangle: usize,
        /// The number of triangles at the edge.
        triangles: usize,
    },
    /// Two tetrahedra share a face and are on the same side of it, or more than two share a face.
    Overlap {
        /// The first two tetrahedra.
        tetrahedra: [usize; 2],
        /// The face.
        face: [Vertex; 3],
    },
    /// There are 2^32 / 3 triangles or more.
    TooMany,
}

impl MaterialError {
    /// The first bad triangle; `None` if the error has none.
    #[must_use]
    pub const fn triangle(&self) -> Option<usize> {
        match self {
            MaterialError::Empty | MaterialError::TooMany | MaterialError::Overlap { .. } => None,
            MaterialError::NoSuchVertex { triangle, .. }
            | MaterialError::Repeated { triangle, .. }
            | MaterialError::Open { triangle, .. } => Some(*triangle),
        }
    }
}

impl std::fmt::Display for MaterialError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            MaterialError::Empty => write!(f, "a mesh without triangles"),
            MaterialError::NoSuchVertex { triangle, vertex } => {
                write!(f, "triangle {triangle} has vertex {vertex}, which is no point of the scene")
            }
            MaterialError::Repeated { triangle, vertex } => write!(f, "triangle {triangle} has vertex {vertex} twice"),
            MaterialError::Open { edge: [a, b], region, triangle, triangles } => write!(
                f,
                "the boundary of region {region} is not closed at the edge of vertices {a} and {b}, which has {triangles} \
                 triangle(s), {triangle} among them"
            ),
            MaterialError::Overlap { tetrahedra: [s, t], face: [a, b, c] } => {
                write!(f, "tetrahedra {s} and {t} are on the same side of the face of vertices {a}, {b} and {c}")
            }
            MaterialError::TooMany => write!(f, "a mesh holds fewer than 2^32 / 3 triangles"),
        }
    }
}

impl std::error::Error for MaterialError {}

/// Checks each triangle on its own.
fn check_triangles(vertices: usize, triangles: &[[Vertex; 3]]) -> Result<(), MaterialError> {
    if triangles.is_empty() {
        return Err(MaterialError::Empty);
    }
    if triangles.len() >= (u32::MAX / 3) as usize {
        return Err(MaterialError::TooMany);
    }
    let wrong = |(triangle, &[a, b, c]): (usize, &[Vertex; 3])| {
        let missing = [a, b, c].into_iter().find(|v| v.index() >= vertices);
        let twice = [(a, b), (b, c), (c, a)].into_iter().find(|(u, v)| u == v).map(|(v, _)| v);
        let missing = missing.map(|vertex| MaterialError::NoSuchVertex { triangle, vertex });
        missing.or(twice.map(|vertex| MaterialError::Repeated { triangle, vertex }))
    };
    triangles.iter().enumerate().find_map(wrong).map_or(Ok(()), Err)
}

/// Triangles with the regions in front of them and behind them; all boundaries of regions are closed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct MaterialMesh {
    triangles: Vec<[Vertex; 3]>,
    /// The region in front of each triangle, and the region behind it.
    sides: Vec<[u32; 2]>,
    regions: u32,
}

impl MaterialMesh {
    /// A mesh of triangles over the first `vertices` vertices of a scene.
    ///
    /// The front of a triangle is the side from which its corners appear counterclockwise. The first of `sides` is the
    /// region in front, the second the region behind. Region [`OUTSIDE`] is outside of everything.
    ///
    /// # Errors
    /// [`MaterialError`] for the first wrong triangle, else the first wrong edge by its vertices.
    ///
    /// # Panics
    /// If the numbers of sides and of triangles differ.
    pub fn new(
        vertices: usize,
        triangles: Vec<[Vertex; 3]>,
        sides: Vec<[u32; 2]>,
    ) -> Result<MaterialMesh, MaterialError> {
        assert_eq!(triangles.len(), sides.len(), "a pair of sides for each triangle");
        check_triangles(vertices, &triangles)?;
        if let Some(open) = open_edge(vertices, &triangles, &sides) {
            return Err(open);
        }
        let regions = sides.as_flattened().iter().max().map_or(0, |&region| region + 1);
        Ok(MaterialMesh { triangles, sides, regions })
    }

    /// The largest side of the bounding box of a triangle, rounded up so that no exact coordinate difference within a
    /// triangle is larger.
    #[must_use]
    pub fn primitive_length(&self, scene: &Scene) -> f64 {
        longest(scene, self.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]))
    }

    /// The mesh of a closed surface, counterclockwise as seen from outside; region 1 is inside of it.
    ///
    /// # Errors
    /// As [`MaterialMesh::new`].
    pub fn of_closed(vertices: usize, triangles: Vec<[Vertex; 3]>) -> Result<MaterialMesh, MaterialError> {
        let sides = vec![[OUTSIDE, 1]; triangles.len()];
        MaterialMesh::new(vertices, triangles, sides)
    }

    /// The mesh of some triangles of a closed surface, counterclockwise as seen from outside; region 1 is behind them.
    ///
    /// It is not checked that the triangles are of such a surface.
    ///
    /// # Errors
    /// [`MaterialError::Empty`], [`MaterialError::TooMany`], [`MaterialError::NoSuchVertex`] and
    /// [`MaterialError::Repeated`], as [`MaterialMesh::new`].
    pub fn part_of_closed(vertices: usize, triangles: Vec<[Vertex; 3]>) -> Result<MaterialMesh, MaterialError> {
        check_triangles(vertices, &triangles)?;
        let sides = vec![[OUTSIDE, 1]; triangles.len()];
        Ok(MaterialMesh { triangles, sides, regions: 2 })
    }

    /// The mesh of the faces of tetrahedra, each of which is a region: the tetrahedron with index 0 is region 1.
    ///
    /// Each tetrahedron a, b, c, d has a positive `orient3d`: a, b, c appear counterclockwise when d is behind them.
    ///
    /// # Errors
    /// As [`MaterialMesh::new`], and [`MaterialError::Overlap`].
    pub fn of_tetrahedra(vertices: usize, tetrahedra: &[[Vertex; 4]]) -> Result<MaterialMesh, MaterialError> {
        // Each face by its sorted vertices, and as its tetrahedron has it: counterclockwise as seen from outside.
        let outward = |&[a, b, c, d]: &[Vertex; 4]| [[a, b, c], [b, a, d], [c, b, d], [a, c, d]];
        let mut faces: Vec<([Vertex; 3], usize, [Vertex; 3])> = Vec::with_capacity(4 * tetrahedra.len());
        for (at, tetrahedron) in tetrahedra.iter().enumerate() {
            for face in outward(tetrahedron) {
                let mut key = face;
                key.sort_unstable();
                faces.push((key, at, face));
            }
        }
        faces.par_sort_unstable();
        let (mut triangles, mut sides) = (Vec::new(), Vec::new());
        let region = |at: usize| u32::try_from(at + 1).map_err(|_| MaterialError::TooMany);
        for shared in faces.chunk_by(|a, b| a.0 == b.0) {
            let (_, first, face) = shared[0];
            let other = match *shared {
                [_] => OUTSIDE,
                // An even permutation of the same corners is the same side.
                [_, (_, second, [a, b, c])] if ![[a, b, c], [b, c, a], [c, a, b]].contains(&face) => region(second)?,
                [_, (_, second, _), ..] => {
                    return Err(MaterialError::Overlap { tetrahedra: [first, second], face });
                }
                [] => continue,
            };
            triangles.push(face);
            sides.push([other, region(first)?]);
        }
        MaterialMesh::new(vertices, triangles, sides)
    }

    /// The mesh with all vertex numbers increased by `by`.
    ///
    /// # Panics
    /// As [`Vertex::input`].
    #[must_use]
    pub fn shifted(mut self, by: usize) -> MaterialMesh {
        for v in self.triangles.as_flattened_mut() {
            *v = Vertex::input(v.index() + by);
        }
        self
    }

    /// The triangles.
    #[inline]
    #[must_use]
    pub fn triangles(&self) -> &[[Vertex; 3]] {
        &self.triangles
    }

    /// The region in front of each triangle, and the region behind it.
    #[inline]
    #[must_use]
    pub fn sides(&self) -> &[[u32; 2]] {
        &self.sides
    }

    /// The largest region number plus one.
    #[must_use]
    pub fn regions(&self) -> u32 {
        self.regions
    }
}

/// The first edge at which a region's boundary is not closed.
///
/// A counting sort groups edges by their lower vertex, so the cost is linear, and each vertex is checked independently.
fn open_edge(vertices: usize, triangles: &[[Vertex; 3]], sides: &[[u32; 2]]) -> Option<MaterialError> {
    let edge = |side: u32| {
        let triangle = &triangles[(side / 3) as usize];
        let k = (side % 3) as usize;
        [triangle[k], triangle[(k + 1) % 3]]
    };
    let lower = |side: u32| edge(side).map(Vertex::index).into_iter().min().expect("two ends");
    let count = u32::try_from(3 * triangles.len()).expect("checked by the caller");
    // First the end of each vertex' sides; after the sides are filled in from the end, the start.
    let mut starts = vec![0_u32; vertices + 1];
    (0..count).for_each(|side| starts[lower(side)] += 1);
    let mut sum = 0;
    for start in &mut starts {
        sum += *start;
        *start = sum;
    }
    let mut of_vertex = vec![0_u32; count as usize];
    for side in (0..count).rev() {
        let start = &mut starts[lower(side)];
        *start -= 1;
        of_vertex[*start as usize] = side;
    }
    let at_vertex = |v: usize| {
        let around = &of_vertex[starts[v] as usize..starts[v + 1] as usize];
        // Each use of an edge by a region, ascending: the other end, the region, the direction, the triangle.
        let mut uses: Vec<(usize, u32, i32, u32)> = Vec::with_capacity(2 * around.len());
        for &side in around {
            let [from, to] = edge(side).map(Vertex::index);
            let way = if from < to { 1 } else { -1 };
            let [front, back] = sides[(side / 3) as usize];
            uses.extend([(from.max(to), front, -way, side / 3), (from.max(to), back, way, side / 3)]);
        }
        uses.sort_unstable();
        let open =
            uses.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).find(|uses| uses.iter().map(|of| of.2).sum::<i32>() != 0)?;
        let (other, region, _, triangle) = open[0];
        Some(MaterialError::Open {
            edge: [v, other].map(Vertex::input),
            region,
            triangle: triangle as usize,
            triangles: uses.iter().filter(|of| of.0 == other).count() / 2,
        })
    };
    (0..vertices).into_par_iter().find_map_first(at_vertex)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn v(index: usize) -> Vertex {
        Vertex::input(index)
    }

    fn tetrahedron() -> Vec<[Vertex; 3]> {
        [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(|triangle| triangle.map(v)).to_vec()
    }

    #[test]
    fn closed_surfaces_have_an_inside_and_an_outside() {
        let mesh = MaterialMesh::of_closed(4, tetrahedron()).unwrap();
        assert_eq!((mesh.regions(), mesh.sides()), (2, &[[OUTSIDE, 1]; 4][..]));
    }

    #[test]
    fn what_is_wrong_is_named() {
        let wrong = |triangles: Vec<[Vertex; 3]>| MaterialMesh::of_closed(4, triangles).unwrap_err();
        assert_eq!(wrong(Vec::new()), MaterialError::Empty);
        let mut open = tetrahedron();
        open.pop();
        let edge = MaterialError::Open { edge: [v(0), v(2)], region: 0, triangle: 0, triangles: 1 };
        assert_eq!(wrong(open), edge);
        let mut turned = tetrahedron();
        turned[3].swap(0, 1);
        assert!(matches!(wrong(turned), MaterialError::Open { triangles: 2, .. }));
        let mut missing = tetrahedron();
        missing[1][2] = v(4);
        assert_eq!(wrong(missing), MaterialError::NoSuchVertex { triangle: 1, vertex: v(4) });
        let mut twice = tetrahedron();
        twice[2][2] = v(1);
        assert_eq!(wrong(twice), MaterialError::Repeated { triangle: 2, vertex: v(1) });
        // A side that contradicts the others.
        let mut sides = vec![[OUTSIDE, 1]; 4];
        sides[2] = [OUTSIDE, 2];
        let error = MaterialMesh::new(4, tetrahedron(), sides).unwrap_err();
        assert!(
            matches!(error, MaterialError::Open { edge: [a, b], region: 1, .. } if [a, b] == [v(1), v(2)]),
            "{error}"
        );
    }

    #[test]
    fn an_open_edge_is_the_first_one_and_its_region_the_lowest() {
        let error = |vertices, triangles, sides| MaterialMesh::new(vertices, triangles, sides).unwrap_err();
        // Without the last face, the directions around the edge of 0 and 2 do not balance, in either orientation.
        for mirrored in [false, true] {
            let mut open = tetrahedron();
            open.pop();
            if mirrored {
                open.iter_mut().for_each(|triangle| triangle.swap(0, 1));
            }
            let expected = MaterialError::Open { edge: [v(0), v(2)], region: 0, triangle: 0, triangles: 1 };
            assert_eq!(error(4, open, vec![[OUTSIDE, 1]; 3]), expected);
        }
        // Two tetrahedra share a corner, and the second has a flipped face. The edge before the open edge is closed,
        // and its last region is the first of the open edge.
        let around = |corners: [usize; 4]| tetrahedron().into_iter().map(move |of| of.map(|at| v(corners[at.index()])));
        let mut triangles: Vec<[Vertex; 3]> = around([0, 1, 3, 4]).chain(around([0, 2, 5, 6])).collect();
        let sides = [vec![[OUTSIDE, 1]; 4], vec![[1, 2]; 4]].concat();
        triangles[5].swap(0, 1);
        let expected = MaterialError::Open { edge: [v(0), v(2)], region: 1, triangle: 4, triangles: 2 };
        assert_eq!(error(7, triangles, sides), expected);
    }

    #[test]
    fn the_first_open_edge_is_found_on_any_number_of_threads() {
        // One open edge is just before the middle of the vertices, the other right behind it, where a second thread
        // begins.
        let count = 4_000;
        let mut triangles = Vec::new();
        for first in (0..count).map(|at| 4 * at) {
            triangles.extend(tetrahedron().into_iter().map(|of| of.map(|at| v(first + at.index()))));
        }
        for tetrahedron in [count / 2, count / 2 - 1] {
            triangles.remove(4 * tetrahedron + 3);
        }
        let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
        let first = 4 * (count / 2 - 1);
        for _ in 0..10 {
            let error = pool.install(|| MaterialMesh::of_closed(4 * count, triangles.clone()).unwrap_err());
            assert!(matches!(error, MaterialError::Open { edge: [a, _], .. } if a == v(first)), "{error}");
        }
    }

    #[test]
    fn tetrahedra_share_their_faces() {
        // Two tetrahedra on the face 0, 1, 2: one above, one below.
        let [below, above] = [[0, 1, 2, 3], [0, 2, 1, 4]].map(|corners| corners.map(v));
        let mesh = MaterialMesh::of_tetrahedra(5, &[below, above]).unwrap();
        assert_eq!((mesh.triangles().len(), mesh.regions()), (7, 3));
        let shared = mesh.sides().iter().filter(|sides| !sides.contains(&OUTSIDE)).count();
        assert_eq!(shared, 1);
        let same_side = [[0, 1, 2, 3], [0, 1, 2, 4]].map(|corners| corners.map(v));
        let error = MaterialMesh::of_tetrahedra(5, &same_side).unwrap_err();
        assert_eq!(error, MaterialError::Overlap { tetrahedra: [0, 1], face: [0, 1, 2].map(v) });
        let thrice = [below, above, [0, 2, 1, 5].map(v)];
        assert!(matches!(MaterialMesh::of_tetrahedra(6, &thrice), Err(MaterialError::Overlap { .. })));
    }
}
