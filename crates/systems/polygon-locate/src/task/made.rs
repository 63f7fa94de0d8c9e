//! Data that the algorithm makes of a content, once for all backends.

use predicament_predicates::Scene;

use super::content::MapWithProbes;
use crate::algorithm::LocateIndex;

impl MapWithProbes {
    /// The map's edges, ready for queries. They are built once: this uses no predicate, so all backends share it.
    pub fn locate_index(&self, scene: &Scene) -> &LocateIndex {
        self.made(|| LocateIndex::new(&self.map, scene))
    }
}
