//! The overlay of two meshes as it is answered: its triangles, what they are pieces of, and the regions beside them.

use predicament_mesh::MaterialMesh;
use predicament_predicates::Vertex;

/// The triangle of a mesh that a triangle of a result is, or is a piece of.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Source {
    /// The first mesh, 0, or the second, 1.
    pub mesh: u8,
    /// Its place there.
    pub triangle: u32,
}

/// The overlay of both meshes: each triangle with the regions of both on either side.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Regions {
    /// By input vertices and constructed ones.
    pub triangles: Vec<[Vertex; 3]>,
    /// For each the place of the pair of regions in front of it, and of that behind it.
    pub sides: Vec<[u32; 2]>,
    /// For each what it is, or is a piece of.
    pub sources: Vec<Source>,
    /// A region of the first mesh and one of the second, ascending.
    pub pairs: Vec<[u32; 2]>,
}

impl Regions {
    /// A mesh of all of it, over so many vertices, where these are all input vertices.
    ///
    /// # Errors
    /// As [`MaterialMesh::new`].
    pub fn into_mesh(self, vertices: usize) -> Result<MaterialMesh, predicament_mesh::MaterialError> {
        MaterialMesh::new(vertices, self.triangles, self.sides)
    }
}
