//! The answer of an overlay of two meshes: its triangles, their sources, and the regions beside them.

use predicament_mesh::MaterialMesh;
use predicament_predicates::Vertex;

/// The source of a result's triangle: the triangle of a mesh that contains it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Source {
    /// The mesh: the first (0), or the second (1).
    pub mesh: u8,
    /// The triangle's index in the mesh.
    pub triangle: u32,
}

/// The overlay of both meshes: each triangle with the regions of both on either side.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Regions {
    /// The triangles, as input vertices and constructed ones.
    pub triangles: Vec<[Vertex; 3]>,
    /// For each triangle, the index of the pair of regions in front of it, and behind it.
    pub sides: Vec<[u32; 2]>,
    /// For each triangle, its source.
    pub sources: Vec<Source>,
    /// For each of the last triangles, which both meshes have, its triangle in the second mesh; its source is in the
    /// first.
    pub also: Vec<u32>,
    /// Pairs of a region of the first mesh and a region of the second, ascending.
    pub pairs: Vec<[u32; 2]>,
}

impl Regions {
    /// A mesh of all triangles, over `vertices` vertices, if these are all input vertices.
    ///
    /// # Errors
    /// As [`MaterialMesh::new`].
    pub fn into_mesh(self, vertices: usize) -> Result<MaterialMesh, predicament_mesh::MaterialError> {
        MaterialMesh::new(vertices, self.triangles, self.sides)
    }
}
