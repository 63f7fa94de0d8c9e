//! The smallest pair of each kind, of polygons as of surfaces.

use std::collections::BTreeMap;

use predicament_tasks::Contestant;
use rayon::prelude::*;

use crate::Precision;
use crate::shrink::{Shrink, Shrunk};

/// So many scenes are tried for one find.
const LIMIT: u64 = 20_000;

/// A pair whose contacts contradict each other, by its place in a stream.
pub trait Find: Sync {
    /// What is found.
    type Pair: Shrink + Send;
    /// How it is made.
    type Recipe: Copy + Send;
    /// What it has in common with others.
    type Kind: Ord + Send;

    /// The recipe that made it, and its number in the stream.
    fn from(&self) -> (Self::Recipe, u64);

    /// The pair, made again.
    fn pair(&self, precision: Precision, seed: u64) -> Self::Pair;

    /// Shrinks it, keeping what was found: the first backend contradicts itself, the second, exact, does not.
    fn shrunk(&self, backends: [&dyn Contestant; 2], pair: Self::Pair, limit: u64) -> Shrunk<Self::Pair>;

    /// The kind of a pair.
    fn kind(backend: &dyn Contestant, pair: &Self::Pair) -> Self::Kind;
}

/// A pair that was shrunk, and where it is from.
#[derive(Clone, PartialEq, Debug)]
pub struct Small<P, R> {
    /// The pair.
    pub pair: P,
    /// Whether nothing smaller was found to show the same; not so if the limit came first.
    pub minimal: bool,
    /// The recipe that made the find.
    pub recipe: R,
    /// The find's number in its stream.
    pub number: u64,
}

impl<P: Shrink, R> Small<P, R> {
    /// Puts it among the smallest if it is the smaller of its kind; of two as
    /// small the one that was there stays.
    pub fn keep<K: Ord>(self, kept: &mut BTreeMap<K, Self>, kind: K) {
        let key = |small: &Self| (small.pair.size(), !small.minimal);
        if kept.get(&kind).is_none_or(|known| key(&self) < key(known)) {
            kept.insert(kind, self);
        }
    }
}

/// The smallest pair of each kind of these finds.
pub type Smallest<F> = BTreeMap<<F as Find>::Kind, Small<<F as Find>::Pair, <F as Find>::Recipe>>;

/// Shrinks finds of a backend, each for what was found of it, and keeps the
/// smallest of each kind. The second backend is exact.
///
/// # Panics
/// If the backend declines a pair that it found.
#[must_use]
pub fn smallest<F: Find>(backends: [&dyn Contestant; 2], precision: Precision, seed: u64, finds: &[&F]) -> Smallest<F> {
    let one = |found: &&F| {
        let shrunk = found.shrunk(backends, found.pair(precision, seed), LIMIT);
        let kind = F::kind(backends[0], &shrunk.scene);
        let (recipe, number) = found.from();
        (kind, Small { pair: shrunk.scene, minimal: shrunk.minimal, recipe, number })
    };
    let all: Vec<_> = finds.par_iter().map(one).collect();
    let mut kept = BTreeMap::new();
    for (kind, small) in all {
        small.keep(&mut kept, kind);
    }
    kept
}
