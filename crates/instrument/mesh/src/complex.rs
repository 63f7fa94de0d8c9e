//! Simplicial complexes: vertices, edges, triangles and tetrahedra, closed under taking faces.
//!
//! Curves, surfaces and solids are all sets of simplices that meet in common faces. Every simplex is stored once, with
//! its vertices in ascending order, so results cannot depend on how the simplex was written down.

use predicament_predicates::{Dimension, Scene, Vertex};

use crate::length::longest;

/// The reason why a list of simplices is not a complex of a scene.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ComplexError {
    /// A simplex uses a vertex that the scene lacks, or a vertex that is not an input vertex.
    NoSuchVertex {
        /// The vertices of the simplex, as given.
        simplex: Vec<Vertex>,
        /// The vertex.
        vertex: Vertex,
    },
    /// A simplex names a vertex twice.
    Repeated {
        /// The vertices of the simplex, as given.
        simplex: Vec<Vertex>,
        /// The vertex.
        vertex: Vertex,
    },
    /// A tetrahedron is in a 2D scene.
    Dimension {
        /// The vertices of the tetrahedron, as given.
        simplex: Vec<Vertex>,
    },
    /// There are 2^32 simplices or more of one rank.
    TooMany,
}

impl std::fmt::Display for ComplexError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let list = |simplex: &[Vertex]| {
            let names: Vec<String> = simplex.iter().map(ToString::to_string).collect();
            format!("the simplex [{}]", names.join(", "))
        };
        match self {
            ComplexError::NoSuchVertex { simplex, vertex } => {
                write!(f, "{} has vertex {vertex}, which is no point of the scene", list(simplex))
            }
            ComplexError::Repeated { simplex, vertex } => {
                write!(f, "{} has vertex {vertex} twice", list(simplex))
            }
            ComplexError::Dimension { simplex } => write!(f, "{} needs a 3D scene", list(simplex)),
            ComplexError::TooMany => write!(f, "a complex holds at most 2^32 simplices of one kind"),
        }
    }
}

impl std::error::Error for ComplexError {}

/// A simplex of a complex, as its rank and its index among the simplices of that rank.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Simplex {
    /// The dimension: 0 for a vertex, 1 for an edge, 2 for a triangle, 3 for a tetrahedron.
    pub rank: u8,
    /// The index in [`Complex::vertices`], [`Complex::edges`] and so on.
    pub index: u32,
}

/// A simplicial complex over a scene's vertices.
///
/// Each list is sorted, without repetitions, and each simplex has its vertices
/// in ascending order; every face of a simplex is there too.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Complex {
    vertices: Vec<Vertex>,
    edges: Vec<[Vertex; 2]>,
    triangles: Vec<[Vertex; 3]>,
    tetrahedra: Vec<[Vertex; 4]>,
    maximal: Vec<Simplex>,
}

/// Simplices as given: in any order, with faces omitted or repeated.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Simplices {
    /// Isolated vertices.
    pub vertices: Vec<Vertex>,
    /// Edges.
    pub edges: Vec<[Vertex; 2]>,
    /// Triangles.
    pub triangles: Vec<[Vertex; 3]>,
    /// Tetrahedra (3D scenes).
    pub tetrahedra: Vec<[Vertex; 4]>,
}

impl Complex {
    /// The complex of these simplices and all their faces.
    ///
    /// # Errors
    /// [`ComplexError`] for the first invalid simplex.
    pub fn new(scene: &Scene, given: &Simplices) -> Result<Complex, ComplexError> {
        let mut complex = Complex::default();
        if let (Dimension::Two, Some(simplex)) = (scene.dimension(), given.tetrahedra.first()) {
            return Err(ComplexError::Dimension { simplex: simplex.to_vec() });
        }
        let given_vertices: Vec<[Vertex; 1]> = given.vertices.iter().map(|&v| [v]).collect();
        let mut maximal: [Vec<u32>; 4] = Default::default();
        (complex.tetrahedra, maximal[3]) = canonical(scene, &given.tetrahedra, [])?;
        let faces = complex.tetrahedra.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, b, d], [a, c, d], [b, c, d]]);
        (complex.triangles, maximal[2]) = canonical(scene, &given.triangles, faces)?;
        let sides = complex.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [a, c], [b, c]]);
        (complex.edges, maximal[1]) = canonical(scene, &given.edges, sides)?;
        let ends = complex.edges.as_flattened().iter().map(|&v| [v]);
        let vertices;
        (vertices, maximal[0]) = canonical(scene, &given_vertices, ends)?;
        complex.vertices = vertices.into_iter().map(|[v]| v).collect();
        let by_rank = (0..).zip(&maximal);
        complex.maximal = by_rank.flat_map(|(rank, of)| of.iter().map(move |&index| Simplex { rank, index })).collect();
        Ok(complex)
    }

    /// All vertices, in ascending order.
    #[must_use]
    pub fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }

    /// All edges, in ascending order.
    #[must_use]
    pub fn edges(&self) -> &[[Vertex; 2]] {
        &self.edges
    }

    /// All triangles, in ascending order.
    #[must_use]
    pub fn triangles(&self) -> &[[Vertex; 3]] {
        &self.triangles
    }

    /// All tetrahedra, in ascending order.
    #[must_use]
    pub fn tetrahedra(&self) -> &[[Vertex; 4]] {
        &self.tetrahedra
    }

    /// The simplices that are not faces of others, in ascending order.
    #[must_use]
    pub fn maximal(&self) -> &[Simplex] {
        &self.maximal
    }

    /// The number of simplices of all ranks.
    #[must_use]
    pub fn len(&self) -> usize {
        self.vertices.len() + self.edges.len() + self.triangles.len() + self.tetrahedra.len()
    }

    /// True if there are no simplices.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.vertices.is_empty()
    }

    /// The vertices of a simplex, in ascending order.
    ///
    /// # Panics
    /// If the complex has no such simplex.
    #[inline]
    #[must_use]
    pub fn vertices_of(&self, simplex: Simplex) -> &[Vertex] {
        let index = simplex.index as usize;
        match simplex.rank {
            0 => std::slice::from_ref(&self.vertices[index]),
            1 => &self.edges[index],
            2 => &self.triangles[index],
            3 => &self.tetrahedra[index],
            rank => panic!("a simplex has rank 0 to 3, not {rank}"),
        }
    }

    /// The simplex with these vertices, which must be in ascending order.
    #[must_use]
    pub fn find(&self, vertices: &[Vertex]) -> Option<Simplex> {
        let (rank, place) = match *vertices {
            [a] => (0, self.vertices.binary_search(&a)),
            [a, b] => (1, self.edges.binary_search(&[a, b])),
            [a, b, c] => (2, self.triangles.binary_search(&[a, b, c])),
            [a, b, c, d] => (3, self.tetrahedra.binary_search(&[a, b, c, d])),
            _ => return None,
        };
        place.ok().and_then(|index| Some(Simplex { rank, index: u32::try_from(index).ok()? }))
    }

    /// The largest edge of a simplex' bounding box, rounded up so that no exact coordinate difference within a simplex
    /// is larger. Zero if all simplices are single points.
    #[must_use]
    pub fn primitive_length(&self, scene: &Scene) -> f64 {
        // The extent of a simplex along an axis is that of one of its edges.
        longest(scene, self.edges.iter().copied())
    }
}

/// Given simplices and the faces of larger simplices: checked, sorted, without repetitions; and the indices of the
/// simplices that are not faces.
fn canonical<const N: usize>(
    scene: &Scene,
    given: &[[Vertex; N]],
    faces: impl IntoIterator<Item = [Vertex; N]>,
) -> Result<(Vec<[Vertex; N]>, Vec<u32>), ComplexError> {
    // A face sorts before the same simplex as given, and deduplication keeps the face.
    let mut all: Vec<([Vertex; N], bool)> = Vec::with_capacity(given.len());
    for simplex in given {
        let mut sorted = *simplex;
        sorted.sort_unstable();
        if let Some(&vertex) = sorted.iter().find(|vertex| vertex.index() >= scene.len()) {
            return Err(ComplexError::NoSuchVertex { simplex: simplex.to_vec(), vertex });
        }
        if let Some(pair) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(ComplexError::Repeated { simplex: simplex.to_vec(), vertex: pair[0] });
        }
        all.push((sorted, true));
    }
    all.extend(faces.into_iter().map(|face| (face, false)));
    all.sort_unstable();
    all.dedup_by_key(|(simplex, _)| *simplex);
    if u32::try_from(all.len()).is_err() {
        return Err(ComplexError::TooMany);
    }
    let maximal = (0..).zip(&all).filter(|(_, (_, is_maximal))| *is_maximal).map(|(place, _)| place).collect();
    Ok((all.into_iter().map(|(simplex, _)| simplex).collect(), maximal))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn v<const N: usize>(indices: [usize; N]) -> [Vertex; N] {
        indices.map(Vertex::input)
    }

    fn scene() -> Scene {
        let points = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0], [9.0, 9.0, 9.0]];
        Scene::from_points3(&points).unwrap()
    }

    #[test]
    fn faces_come_with_their_simplices_and_everything_is_there_once() {
        let given = Simplices {
            tetrahedra: vec![v([3, 1, 0, 2])],
            triangles: vec![v([2, 1, 0]), v([1, 4, 0])],
            vertices: v([4, 4]).to_vec(),
            ..Simplices::default()
        };
        let complex = Complex::new(&scene(), &given).unwrap();
        assert_eq!(complex.tetrahedra(), [v([0, 1, 2, 3])]);
        let triangles = [v([0, 1, 2]), v([0, 1, 3]), v([0, 1, 4]), v([0, 2, 3]), v([1, 2, 3])];
        assert_eq!(complex.triangles(), triangles);
        assert_eq!(complex.edges().len(), 8);
        assert_eq!(complex.vertices(), v([0, 1, 2, 3, 4]));
        assert_eq!(complex.len(), 1 + 5 + 8 + 5);
        assert_eq!(complex.vertices_of(Simplex { rank: 2, index: 2 }), v([0, 1, 4]));
        assert_eq!(complex.maximal(), [Simplex { rank: 2, index: 2 }, Simplex { rank: 3, index: 0 }]);
    }

    #[test]
    fn what_is_no_simplex_is_refused_by_name() {
        let refused = |given: &Simplices| Complex::new(&scene(), given).unwrap_err().to_string();
        let edges = |edges: &[[Vertex; 2]]| Simplices { edges: edges.to_vec(), ..Simplices::default() };
        assert!(refused(&edges(&[v([0, 1]), v([2, 2])])).contains("[2, 2] has vertex 2 twice"));
        assert!(refused(&edges(&[v([0, 5])])).contains("[0, 5] has vertex 5, which is no point"));
        let flat = Scene::from_points2(&[[0.0; 2]; 5]).unwrap();
        let given = Simplices { tetrahedra: vec![v([0, 1, 2, 3])], ..Simplices::default() };
        assert!(Complex::new(&flat, &given).unwrap_err().to_string().contains("needs a 3D scene"));
        assert_eq!(Complex::new(&flat, &Simplices::default()), Ok(Complex::default()));
    }

    #[test]
    fn the_length_is_that_of_the_longest_edge_along_an_axis_and_never_too_small() {
        let length = |points: &[[f64; 3]]| {
            let scene = Scene::from_points3(points).unwrap();
            let given = Simplices { edges: vec![v([0, 1])], vertices: v([2]).to_vec(), ..Simplices::default() };
            Complex::new(&scene, &given).unwrap().primitive_length(&scene)
        };
        assert_eq!(length(&[[0.0, 7.0, 1.0], [1.0, 2.0, 3.0], [99.0; 3]]), 5.0);
        assert_eq!(length(&[[1.0, 0.0, 0.0], [-(2.0_f64.powi(-60)), 0.0, 0.0], [0.0; 3]]), 1.0_f64.next_up());
        assert_eq!(length(&[[1.0; 3], [1.0; 3], [0.0; 3]]), 0.0);
        assert_eq!(length(&[[f64::MAX, 0.0, 0.0], [f64::MIN, 0.0, 0.0], [0.0; 3]]), f64::INFINITY);
    }
}
