//! Multi-material meshes: triangles with a region on either side.
//!
//! A closed surface is the simple case, of an inside and an outside. Regions that touch share triangles, so that
//! no point between them is in both or in none.
//!
//! # What is refused
//! The boundary of a region is the chain of all triangles that have it on one side, each turned so that it sees the
//! region behind it. If each edge is used by it as often one way as the other, the chain is closed, and each point off it has a
//! winding number: any ray from a point counts the same. [`MaterialMesh::new`] refuses what is not closed in this
//! sense: open surfaces, triangles that are turned over, and regions that contradict each other across an edge. Surfaces may
//! touch and cross themselves otherwise, and an edge may have any number of triangles.

use rayon::prelude::*;

use predicament_predicates::{Scene, Vertex};

use crate::length::longest;

/// The region outside of everything.
pub const OUTSIDE: u32 = 0;

/// Why triangles with regions make no mesh.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum MaterialError {
    /// There are no triangles.
    Empty,
    /// A triangle has a vertex that the scene lacks.
    NoSuchVertex {
        /// The triangle.
        triangle: usize,
        /// The vertex.
        vertex: Vertex,
    },
    /// A triangle has a vertex twice.
    Repeated {
        /// The triangle.
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
        /// How many triangles the edge has.
        triangles: usize,
    },
    /// Two tetrahedra have a face in common and are on the same side of it, or more than two have one.
    Overlap {
        /// The first two.
        tetrahedra: [usize; 2],
        /// The face.
        face: [Vertex; 3],
    },
    /// There are 2^32 / 3 triangles or more.
    TooMany,
}

impl MaterialError {
    /// The first bad triangle; none where there is no one.
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
    /// For each triangle the region in front and the region behind.
    sides: Vec<[u32; 2]>,
    regions: u32,
}

impl MaterialMesh {
    /// A mesh of triangles over the first `vertices` vertices of a scene.
    ///
    /// In front of a triangle is where its corners are seen counterclockwise. The first of `sides` is the region there, the
    /// second that behind it. Region [`OUTSIDE`] is what is outside of everything.
    ///
    /// # Errors
    /// [`MaterialError`] for the first triangle, else the first edge by its vertices, that is wrong.
    ///
    /// # Panics
    /// If there are not as many sides as triangles.
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

    /// The largest side of the bounding box of a triangle, rounded up so that no exact coordinate difference within a triangle is larger.
    #[must_use]
    pub fn primitive_length(&self, scene: &Scene) -> f64 {
        longest(scene, self.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]))
    }

    /// A closed surface, seen counterclockwise from outside: region 1 is inside of it.
    ///
    /// # Errors
    /// As [`MaterialMesh::new`].
    pub fn of_closed(vertices: usize, triangles: Vec<[Vertex; 3]>) -> Result<MaterialMesh, MaterialError> {
        let sides = vec![[OUTSIDE, 1]; triangles.len()];
        MaterialMesh::new(vertices, triangles, sides)
    }

    /// Some triangles of a closed surface, seen counterclockwise from outside: region 1 is behind them. That they are of such a surface is
    /// not checked.
    ///
    /// # Errors
    /// [`MaterialError::Empty`], [`MaterialError::TooMany`], [`MaterialError::NoSuchVertex`] and [`MaterialError::Repeated`], as
    /// [`MaterialMesh::new`].
    pub fn part_of_closed(vertices: usize, triangles: Vec<[Vertex; 3]>) -> Result<MaterialMesh, MaterialError> {
        check_triangles(vertices, &triangles)?;
        let sides = vec![[OUTSIDE, 1]; triangles.len()];
        Ok(MaterialMesh { triangles, sides, regions: 2 })
    }

    /// The faces of tetrahedra, each of which is a region: the tetrahedron in place 0 is region 1.
    ///
    /// Each tetrahedron a, b, c, d has a positive `orient3d`: a, b, c are seen counterclockwise from where d is behind them.
    ///
    /// # Errors
    /// As [`MaterialMesh::new`], and [`MaterialError::Overlap`].
    pub fn of_tetrahedra(vertices: usize, tetrahedra: &[[Vertex; 4]]) -> Result<MaterialMesh, MaterialError> {
        // Each face by its vertices in order, as its tetrahedron has it: seen counterclockwise from outside.
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

    /// The mesh over vertices that come so many places later.
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

    /// For each triangle the region in front of it and that behind it.
    #[inline]
    #[must_use]
    pub fn sides(&self) -> &[[u32; 2]] {
        &self.sides
    }

    /// One more than the largest number of a region.
    #[must_use]
    pub fn regions(&self) -> u32 {
        self.regions
    }
}

/// The first edge at which a region's boundary is not closed.
///
/// Edges are gathered by their lower vertex, by counting, so that the cost is linear and each vertex is looked at on
/// its own.
fn open_edge(vertices: usize, triangles: &[[Vertex; 3]], sides: &[[u32; 2]]) -> Option<MaterialError> {
    let edge = |side: u32| {
        let triangle = &triangles[(side / 3) as usize];
        let k = (side % 3) as usize;
        [triangle[k], triangle[(k + 1) % 3]]
    };
    let lower = |side: u32| edge(side).map(Vertex::index).into_iter().min().expect("two ends");
    let count = u32::try_from(3 * triangles.len()).expect("checked by the caller");
    // The last side of each vertex, then, as sides are filled in from the end, the first.
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
        // Each use of an edge by a region, ascending: the other end, the region, which way, the triangle.
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
        // Without its last face: around the edge of 0 and 2 more go one way than the other, or the other way.
        for mirrored in [false, true] {
            let mut open = tetrahedron();
            open.pop();
            if mirrored {
                open.iter_mut().for_each(|triangle| triangle.swap(0, 1));
            }
            let expected = MaterialError::Open { edge: [v(0), v(2)], region: 0, triangle: 0, triangles: 1 };
            assert_eq!(error(4, open, vec![[OUTSIDE, 1]; 3]), expected);
        }
        // In a tetrahedron, from the same corner on, another one, one face of which is turned over: the edge before is closed, and
        // its last region is the first of the open one.
        let around = |corners: [usize; 4]| tetrahedron().into_iter().map(move |of| of.map(|at| v(corners[at.index()])));
        let mut triangles: Vec<[Vertex; 3]> = around([0, 1, 3, 4]).chain(around([0, 2, 5, 6])).collect();
        let sides = [vec![[OUTSIDE, 1]; 4], vec![[1, 2]; 4]].concat();
        triangles[5].swap(0, 1);
        let expected = MaterialError::Open { edge: [v(0), v(2)], region: 1, triangle: 4, triangles: 2 };
        assert_eq!(error(7, triangles, sides), expected);
    }

    #[test]
    fn the_first_open_edge_is_found_on_any_number_of_threads() {
        // The one is just before the middle of the vertices, the other right behind it, where a second thread begins.
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
        // Two on the face 0, 1, 2: one above, one below.
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
