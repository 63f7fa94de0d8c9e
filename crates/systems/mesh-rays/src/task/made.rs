//! Data that the algorithm makes of a content, once for all backends.

use predicament_predicates::Scene;

use super::content::RayScene;
use crate::algorithm::MeshTree;

impl RayScene {
    /// The mesh with its tree. It is built once: it uses no predicate, so all backends share it.
    pub fn tree(&self, scene: &Scene) -> &MeshTree {
        self.made(|| MeshTree::new(scene, &self.triangles))
    }
}
