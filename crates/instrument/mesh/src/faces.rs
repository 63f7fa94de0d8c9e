//! The faces of a complex' simplices by index, looked up once.
//!
//! The simplices of a list are sorted, first by their first vertex. Simplices with the same first vertex are adjacent,
//! so a face is found among a few.

use predicament_predicates::Vertex;

use crate::{Complex, Simplex};

/// The indices of the faces of each simplex of a complex.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Faces {
    /// The two vertices of each edge.
    edges: Vec<[u32; 2]>,
    /// The three vertices and three edges of each triangle.
    triangles: Vec<([u32; 3], [u32; 3])>,
    /// The four vertices, six edges and four triangles of each tetrahedron.
    tetrahedra: Vec<([u32; 4], [u32; 6], [u32; 4])>,
}

impl Faces {
    /// The faces of all simplices of this complex.
    #[must_use]
    pub fn new(complex: &Complex) -> Faces {
        let FaceFinder { vertices, edges, triangles, .. } = FaceFinder::new(complex);
        let vertex = |v: Vertex| vertices.first(v);
        let of_triangle = |&[a, b, c]: &[Vertex; 3]| {
            let sides = [[a, b], [a, c], [b, c]];
            ([a, b, c].map(vertex), sides.map(|edge| edges.of(&edge)))
        };
        let of_tetrahedron = |&[a, b, c, d]: &[Vertex; 4]| {
            let sides = [[a, b], [a, c], [a, d], [b, c], [b, d], [c, d]];
            let faces = [[a, b, c], [a, b, d], [a, c, d], [b, c, d]];
            ([a, b, c, d].map(vertex), sides.map(|edge| edges.of(&edge)), faces.map(|face| triangles.of(&face)))
        };
        Faces {
            edges: complex.edges().iter().map(|edge| edge.map(vertex)).collect(),
            triangles: complex.triangles().iter().map(of_triangle).collect(),
            tetrahedra: complex.tetrahedra().iter().map(of_tetrahedron).collect(),
        }
    }

    /// The faces of the simplex in ascending order, then the simplex itself.
    ///
    /// # Panics
    /// If the complex has no such simplex.
    pub fn of(&self, simplex: Simplex) -> impl Iterator<Item = Simplex> + '_ {
        const NONE: &[u32] = &[];
        let at = simplex.index as usize;
        let by_rank: [&[u32]; 3] = match simplex.rank {
            0 => [NONE; 3],
            1 => [&self.edges[at], NONE, NONE],
            2 => [&self.triangles[at].0, &self.triangles[at].1, NONE],
            3 => [&self.tetrahedra[at].0, &self.tetrahedra[at].1, &self.tetrahedra[at].2],
            rank => panic!("a simplex has rank 0 to 3, not {rank}"),
        };
        let faces = (0_u8..).zip(by_rank);
        faces.flat_map(|(rank, places)| places.iter().map(move |&index| Simplex { rank, index })).chain([simplex])
    }
}

/// A finder for the faces of a complex' simplices by index, which looks them up on each call: suited to few calls.
/// Preparation visits each simplex that can be a face once.
#[derive(Debug)]
pub struct FaceFinder<'a> {
    complex: &'a Complex,
    vertices: Places<'a, Vertex>,
    edges: Places<'a, [Vertex; 2]>,
    triangles: Places<'a, [Vertex; 3]>,
}

impl<'a> FaceFinder<'a> {
    /// Prepares a finder for this complex.
    #[must_use]
    pub fn new(complex: &'a Complex) -> FaceFinder<'a> {
        // Simplices that cannot be faces are not indexed.
        let edges = if complex.triangles().is_empty() { &[] } else { complex.edges() };
        let triangles = if complex.tetrahedra().is_empty() { &[] } else { complex.triangles() };
        FaceFinder {
            complex,
            vertices: Places::new(complex.vertices(), |&v| v),
            edges: Places::new(edges, |edge| edge[0]),
            triangles: Places::new(triangles, |triangle| triangle[0]),
        }
    }

    /// Visits the faces of the simplex in ascending order, then the simplex itself.
    ///
    /// # Panics
    /// If the complex has no such simplex.
    #[inline]
    pub fn each(&self, simplex: Simplex, mut visit: impl FnMut(Simplex)) {
        let mut vertex = |v: Vertex| visit(Simplex { rank: 0, index: self.vertices.first(v) });
        match *self.complex.vertices_of(simplex) {
            [_] => {}
            [a, b] => [a, b].into_iter().for_each(vertex),
            [a, b, c] => {
                [a, b, c].into_iter().for_each(&mut vertex);
                for edge in [[a, b], [a, c], [b, c]] {
                    visit(Simplex { rank: 1, index: self.edges.of(&edge) });
                }
            }
            [a, b, c, d] => {
                [a, b, c, d].into_iter().for_each(&mut vertex);
                for edge in [[a, b], [a, c], [a, d], [b, c], [b, d], [c, d]] {
                    visit(Simplex { rank: 1, index: self.edges.of(&edge) });
                }
                for triangle in [[a, b, c], [a, b, d], [a, c, d], [b, c, d]] {
                    visit(Simplex { rank: 2, index: self.triangles.of(&triangle) });
                }
            }
            _ => unreachable!("a simplex has one to four vertices"),
        }
        visit(simplex);
    }
}

/// A sorted list of simplices, and the start of each range with equal first vertices.
#[derive(Debug)]
struct Places<'a, S> {
    simplices: &'a [S],
    first: fn(&S) -> Vertex,
    /// The index of the first vertex of the first simplex.
    lowest: usize,
    /// The start of the range for that vertex and for each later vertex.
    starts: Vec<u32>,
}

impl<'a, S: Ord> Places<'a, S> {
    fn new(simplices: &'a [S], first: fn(&S) -> Vertex) -> Places<'a, S> {
        let lowest = simplices.first().map_or(0, |lowest| first(lowest).index());
        let count = simplices.last().map_or(0, |last| first(last).index() + 1 - lowest);
        let mut starts = Vec::with_capacity(count + 1);
        for (place, simplex) in (0..).zip(simplices) {
            let vertex = first(simplex).index() - lowest;
            // vertices in between start no simplex
            while starts.len() <= vertex {
                starts.push(place);
            }
        }
        starts.push(u32::try_from(simplices.len()).expect("a complex holds fewer than 2^32 simplices of one kind"));
        Places { simplices, first, lowest, starts }
    }

    /// The index of the first simplex that begins with this vertex.
    #[inline]
    fn first(&self, vertex: Vertex) -> u32 {
        self.starts[vertex.index() - self.lowest]
    }

    fn of(&self, face: &S) -> u32 {
        let first = (self.first)(face).index() - self.lowest;
        let start = self.starts[first];
        let among = &self.simplices[start as usize..self.starts[first + 1] as usize];
        let at = among.binary_search(face).expect("a complex has the faces of its simplices");
        start + u32::try_from(at).expect("a complex holds at most 2^32 simplices of one kind")
    }
}

#[cfg(test)]
mod tests {
    use predicament_predicates::Scene;

    use super::*;
    use crate::Simplices;

    #[test]
    fn faces_are_the_simplices_on_subsets_of_the_vertices() {
        let scene = Scene::from_points3(&[[0.0; 3]; 12]).unwrap();
        let v = |indices: &[usize]| -> Vec<Vertex> { indices.iter().map(|&i| Vertex::input(i)).collect() };
        let given = Simplices {
            tetrahedra: [[9, 3, 5, 7], [3, 5, 7, 11], [1, 3, 5, 7]].map(|t| t.map(Vertex::input)).to_vec(),
            triangles: [[1, 2, 4], [3, 9, 10]].map(|t| t.map(Vertex::input)).to_vec(),
            edges: [[4, 5], [0, 11]].map(|e| e.map(Vertex::input)).to_vec(),
            vertices: v(&[6]),
        };
        let complex = Complex::new(&scene, &given).unwrap();
        let (faces, finder) = (Faces::new(&complex), FaceFinder::new(&complex));
        let counts = [complex.vertices().len(), complex.edges().len(), complex.triangles().len(), 3];
        for (rank, count) in (0_u8..).zip(counts) {
            for index in 0..u32::try_from(count).unwrap() {
                let simplex = Simplex { rank, index };
                let vertices = complex.vertices_of(simplex);
                let subset = |bits: u32| vertices.iter().enumerate().filter(move |(i, _)| bits >> i & 1 == 1);
                let mut expected: Vec<Simplex> = (1_u32..1 << vertices.len())
                    .map(|bits| complex.find(&subset(bits).map(|(_, &v)| v).collect::<Vec<_>>()).unwrap())
                    .collect();
                expected.sort_unstable();
                assert_eq!(faces.of(simplex).collect::<Vec<_>>(), expected);
                let mut found = Vec::new();
                finder.each(simplex, |face| found.push(face));
                assert_eq!(found, expected);
            }
        }
    }
}
