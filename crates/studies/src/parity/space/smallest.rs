//! The smallest broken pair of each kind.

use std::collections::BTreeMap;

use predicament_tasks::Contestant;
use rayon::prelude::*;

use super::{Broken, Found, Recipe, SurfacePair, examine, random_surfaces, shrink_broken};
use crate::Precision;
use crate::shrink::Shrink;

/// So many scenes are tried for one find.
const LIMIT: usize = 20_000;

/// What a broken pair has in common with others: how it is broken, and the levels of its contacts.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Kind {
    /// The ways in which it is broken.
    pub ways: Vec<Broken>,
    /// Whether contacts of each level are registered.
    pub registered: [bool; 4],
}

impl Kind {
    fn of(backend: &dyn Contestant, pair: &SurfacePair) -> Kind {
        let examined = examine(backend, pair).expect("it was examined before");
        let has = |level| examined.contacts.registered.iter().any(|contact| contact.a.rank + contact.b.rank == level);
        Kind { ways: examined.broken(), registered: [0, 1, 2, 3].map(has) }
    }
}

/// A pair that was shrunk, and where it is from.
#[derive(Clone, PartialEq, Debug)]
pub struct Small {
    /// The pair.
    pub pair: SurfacePair,
    /// Whether nothing smaller was found to show the same; not so if the limit came first.
    pub minimal: bool,
    /// The recipe that made the find.
    pub recipe: Recipe,
    /// The find's number in its stream.
    pub number: u64,
}

impl Small {
    /// Puts it among the smallest if it is the smaller of its kind; of two as
    /// small the one that was there stays.
    pub fn keep(self, kept: &mut BTreeMap<Kind, Small>, kind: Kind) {
        let key = |small: &Small| (small.pair.size(), !small.minimal);
        if kept.get(&kind).is_none_or(|known| key(&self) < key(known)) {
            kept.insert(kind, self);
        }
    }
}

/// Shrinks finds of a backend, each for the ways in which it was broken, and
/// keeps the smallest of each kind. The second backend is exact.
///
/// # Panics
/// If the backend declines a pair that it found.
#[must_use]
pub fn smallest(
    backends: [&dyn Contestant; 2],
    precision: Precision,
    seed: u64,
    finds: &[&Found],
) -> BTreeMap<Kind, Small> {
    let one = |found: &&Found| {
        let (pair, _) = random_surfaces(found.recipe, precision, seed, found.number);
        let shrunk = shrink_broken(backends, pair, &found.ways, LIMIT);
        let kind = Kind::of(backends[0], &shrunk.scene);
        let Found { recipe, number, .. } = **found;
        (kind, Small { pair: shrunk.scene, minimal: shrunk.minimal, recipe, number })
    };
    let all: Vec<(Kind, Small)> = finds.par_iter().map(one).collect();
    let mut kept = BTreeMap::new();
    for (kind, small) in all {
        small.keep(&mut kept, kind);
    }
    kept
}
