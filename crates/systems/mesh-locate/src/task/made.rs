//! Data that the algorithm makes of a content, once for all backends.

use predicament_predicates::Scene;

use super::content::ProbedMesh;
use crate::algorithm::MeshIndex;

impl ProbedMesh {
    /// The mesh with its grid. It is built once: it uses no predicate, so all backends share it.
    pub fn mesh_index(&self, scene: &Scene) -> &MeshIndex {
        self.made(|| MeshIndex::new(self.mesh.clone(), scene))
    }
}
