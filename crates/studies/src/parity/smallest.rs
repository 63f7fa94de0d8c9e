//! The smallest odd pair of each kind.

use std::collections::BTreeMap;

use predicament_checks::contacts::Seat;
use predicament_tasks::Contestant;
use rayon::prelude::*;

use super::{Found, PolygonPair, Recipe, examine, random_pair, shrink_odd};
use crate::Precision;
use crate::shrink::Shrink;

/// So many scenes are tried for one find.
const LIMIT: usize = 20_000;

/// What an odd pair has in common with others: the rules under which it is odd, and its kinds of contacts.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Kind {
    /// The rules under which it is odd, in the order of [`Seat::ALL`].
    pub odd: [bool; 3],
    /// Whether vertices are registered with vertices, edges with vertices, edges with edges.
    pub registered: [bool; 3],
}

impl Kind {
    /// The rules under which it is odd.
    pub fn seats(&self) -> impl Iterator<Item = Seat> {
        Seat::ALL.into_iter().zip(self.odd).filter(|&(_, odd)| odd).map(|(seat, _)| seat)
    }

    fn of(backend: &dyn Contestant, pair: &PolygonPair) -> Kind {
        let examined = examine(backend, pair).expect("it was examined before");
        let has = |level| examined.contacts.registered.iter().any(|contact| contact.a.rank + contact.b.rank == level);
        Kind { odd: Seat::ALL.map(|seat| examined.crossings(seat).is_odd()), registered: [0, 1, 2].map(has) }
    }
}

/// A pair that was shrunk, and where it is from.
#[derive(Clone, PartialEq, Debug)]
pub struct Small {
    /// The pair.
    pub pair: PolygonPair,
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

/// Shrinks finds of a backend, each for the rules under which it was odd, and
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
        let (pair, _) = random_pair(found.recipe, precision, seed, found.number);
        let shrunk = shrink_odd(backends, pair, &found.seats, LIMIT);
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
