//! Meshes for tests.

use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::{ConversionError, HalfEdge, IndexedFaces, MeshVertex};
use predicament_predicates::Vertex;

/// The mesh of these faces over `vertices` input vertices.
pub fn mesh<F: AsRef<[u32]>>(vertices: usize, faces: &[F]) -> Result<HalfEdgeMesh, ConversionError> {
    let faces: IndexedFaces = faces.iter().map(|face| face.as_ref().iter().copied()).collect();
    HalfEdgeMesh::new((0..vertices).map(Vertex::input).collect(), &faces)
}

pub fn octahedron() -> HalfEdgeMesh {
    let faces = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1], [5, 2, 1], [5, 3, 2], [5, 4, 3], [5, 1, 4]];
    mesh(6, &faces).unwrap()
}

pub fn cube() -> HalfEdgeMesh {
    let faces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
    mesh(8, &faces).unwrap()
}

/// Quadrangles on a grid; if `wraps`, a torus.
pub fn grid(columns: u32, rows: u32, wraps: bool) -> HalfEdgeMesh {
    let (wide, high) = if wraps { (columns, rows) } else { (columns + 1, rows + 1) };
    let at = |x: u32, y: u32| (y % high) * wide + x % wide;
    let cell = |x: u32, y: u32| [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
    let cells: Vec<[u32; 4]> = (0..rows).flat_map(|y| (0..columns).map(move |x| cell(x, y))).collect();
    mesh((wide * high) as usize, &cells).unwrap()
}

/// A polygon, and a fan of triangles on its other side: each edge within the fan joins two corners of the polygon.
pub fn polygon_and_fan(corners: u32) -> HalfEdgeMesh {
    let fan = (2..corners).map(|at| vec![0, at, at - 1]);
    let faces: Vec<Vec<u32>> = std::iter::once((0..corners).collect()).chain(fan).collect();
    mesh(corners as usize, &faces).unwrap()
}

/// A square, and a smaller separate square.
pub fn two_squares() -> HalfEdgeMesh {
    mesh(8, &[[0, 1, 2, 3], [4, 5, 6, 7]]).unwrap()
}

/// The half-edge between two vertices, given by their indices in the scene.
pub fn between(mesh: &HalfEdgeMesh, from: usize, to: usize) -> HalfEdge {
    let of = |index| {
        let mut vertices = mesh.vertices().filter(|&v| mesh.scene_vertex(v) == Vertex::input(index));
        let v: MeshVertex = vertices.next().expect("a vertex");
        assert_eq!(vertices.next(), None);
        v
    };
    mesh.find(of(from), of(to)).expect("an edge")
}
