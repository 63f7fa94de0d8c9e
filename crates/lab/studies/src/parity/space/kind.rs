//! The kinds of broken pairs of surfaces.

use predicament_tasks::Contestant;

use super::super::Find;
use super::{Broken, Found, Recipe, SurfacePair, examine, random_surfaces, shrink_broken};
use crate::Precision;
use crate::shrink::Shrunk;

/// The kind of a broken pair: its contradictions, and the levels of its contacts.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Kind {
    /// The ways in which the pair is broken.
    pub ways: Vec<Broken>,
    /// True if contacts of a level are registered, for each level.
    pub registered: [bool; 4],
}

impl Find for Found {
    type Pair = SurfacePair;
    type Recipe = Recipe;
    type Kind = Kind;

    fn from(&self) -> (Recipe, u64) {
        (self.recipe, self.number)
    }

    fn pair(&self, precision: Precision, seed: u64) -> SurfacePair {
        random_surfaces(self.recipe, precision, seed, self.number).0
    }

    fn shrunk(&self, backends: [&dyn Contestant; 2], pair: SurfacePair, limit: u64) -> Shrunk<SurfacePair> {
        shrink_broken(backends, pair, &self.ways, limit)
    }

    fn kind(backend: &dyn Contestant, pair: &SurfacePair) -> Kind {
        let examined = examine(backend, pair).expect("it was examined before");
        let has = |level| examined.contacts.registered.iter().any(|contact| contact.a.rank + contact.b.rank == level);
        Kind { ways: examined.broken(), registered: [0, 1, 2, 3].map(has) }
    }
}
