//! The smallest pair of each kind, for polygons and surfaces.

use std::collections::BTreeMap;

use predicament_tasks::Contestant;
use rayon::prelude::*;

use crate::Precision;
use crate::shrink::{Shrink, Shrunk};

/// The maximum number of scenes that are tried for one find.
const LIMIT: u64 = 20_000;

/// A pair whose contacts contradict each other, identified by its number in a stream.
pub trait Find: Sync {
    /// The type of the pair.
    type Pair: Shrink + Send;
    /// The type of its recipe.
    type Recipe: Copy + Send;
    /// The type of its kind.
    type Kind: Ord + Send;

    /// The recipe that made it, and its number in the stream.
    fn from(&self) -> (Self::Recipe, u64);

    /// The pair, made again.
    fn pair(&self, precision: Precision, seed: u64) -> Self::Pair;

    /// Shrinks the pair, keeping the find: the first backend contradicts itself, the second, exact, does not.
    fn shrunk(&self, backends: [&dyn Contestant; 2], pair: Self::Pair, limit: u64) -> Shrunk<Self::Pair>;

    /// The kind of a pair.
    fn kind(backend: &dyn Contestant, pair: &Self::Pair) -> Self::Kind;
}

/// A pair that was shrunk, and its origin.
#[derive(Clone, PartialEq, Debug)]
pub struct Small<P, R> {
    /// The pair.
    pub pair: P,
    /// True if no smaller pair shows the same; false if the limit came first.
    pub minimal: bool,
    /// The recipe that made the find.
    pub recipe: R,
    /// The find's number in its stream.
    pub number: u64,
}

impl<P: Shrink, R> Small<P, R> {
    /// Stores the pair if it is the smallest of its kind so far.
    ///
    /// The earlier of two equally small pairs stays.
    pub fn keep<K: Ord>(self, kept: &mut BTreeMap<K, Self>, kind: K) {
        let key = |small: &Self| (small.pair.size(), !small.minimal);
        if kept.get(&kind).is_none_or(|known| key(&self) < key(known)) {
            kept.insert(kind, self);
        }
    }
}

/// The smallest pair of each kind of these finds.
pub type Smallest<F> = BTreeMap<<F as Find>::Kind, Small<<F as Find>::Pair, <F as Find>::Recipe>>;

/// Shrinks finds of a backend, each for its own contradiction, and keeps the smallest of each kind.
///
/// The second backend is exact.
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
