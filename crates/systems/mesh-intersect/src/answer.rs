//! The answer of an overlay of two meshes: its triangles, their sources, the regions beside them, and contacts.

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

/// A face in which two solids touch: the common part of two triangles in one plane.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Contact {
    /// The index of the triangle in either mesh.
    pub of: [u32; 2],
    /// The face as triangles.
    pub triangles: Vec<[Vertex; 3]>,
}

/// Where two solids touch. A point is not listed if it is in a listed segment, nor a segment if it is in a listed face.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Contacts {
    /// Single points.
    pub points: Vec<Vertex>,
    /// Segments, between vertices of the overlay.
    pub segments: Vec<[Vertex; 2]>,
    /// Faces.
    pub faces: Vec<Contact>,
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
