//! The kinds of odd pairs of polygons.

use predicament_contacts::checks::pairs::Seat;
use predicament_tasks::Contestant;

use super::{Find, Found, PolygonPair, Recipe, examine, random_pair, shrink_odd};
use crate::Precision;
use crate::shrink::Shrunk;

/// The kind of an odd pair: the rules under which it is odd, and its kinds of contacts.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Kind {
    /// For each rule, true if the pair is odd under it, in the order of [`Seat::ALL`].
    pub odd: [bool; 3],
    /// True if vertices are registered with vertices, edges with vertices, edges with edges.
    pub registered: [bool; 3],
}

impl Kind {
    /// The rules under which the pair is odd.
    pub fn seats(&self) -> impl Iterator<Item = Seat> {
        Seat::ALL.into_iter().zip(self.odd).filter(|&(_, odd)| odd).map(|(seat, _)| seat)
    }
}

impl Find for Found {
    type Pair = PolygonPair;
    type Recipe = Recipe;
    type Kind = Kind;

    fn from(&self) -> (Recipe, u64) {
        (self.recipe, self.number)
    }

    fn pair(&self, precision: Precision, seed: u64) -> PolygonPair {
        random_pair(self.recipe, precision, seed, self.number).0
    }

    fn shrunk(&self, backends: [&dyn Contestant; 2], pair: PolygonPair, limit: u64) -> Shrunk<PolygonPair> {
        shrink_odd(backends, pair, &self.seats, limit)
    }

    fn kind(backend: &dyn Contestant, pair: &PolygonPair) -> Kind {
        let examined = examine(backend, pair).expect("it was examined before");
        let has = |level| examined.contacts.registered.iter().any(|contact| contact.a.rank + contact.b.rank == level);
        Kind { odd: Seat::ALL.map(|seat| examined.crossings(seat).is_odd()), registered: [0, 1, 2].map(has) }
    }
}
