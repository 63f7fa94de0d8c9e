//! A mesh to simplify, and the number of triangles that it should have.

use predicament_corpus::{Canon, Content, Items, List, Spelled, spelled_points};
use predicament_mesh::HalfEdgeMesh;
use predicament_predicates::{Scene, Vertex};

/// A mesh of triangles, open or closed, and the target.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct MeshToSimplify {
    /// The triangles. Each side belongs to at most two of them, in opposite directions.
    pub triangles: Vec<[Vertex; 3]>,
    /// The requested number of triangles.
    pub target: usize,
}

impl MeshToSimplify {
    /// The mesh over the vertices of the scene.
    ///
    /// # Panics
    /// If the triangles are not a surface; readers of scenes exclude that.
    #[must_use]
    pub fn mesh(&self, scene: &Scene) -> HalfEdgeMesh {
        HalfEdgeMesh::of_scene(scene.len(), &self.triangles)
            .unwrap_or_else(|why| panic!("a scene without a valid mesh: {why}"))
    }
}

impl Content for MeshToSimplify {
    fn count(&self) -> usize {
        self.triangles.len()
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("simplify");
        canon.count(self.target);
        canon.vertices(self.triangles.as_flattened());
    }

    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let lists = vec![List::required("triangles", Items::tuples(&self.triangles))];
        Some(Spelled { words: vec![("target", self.target.to_string())], lists, ..spelled_points(scene) })
    }
}
