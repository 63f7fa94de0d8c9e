//! A search through many pairs under several backends, with counts.

use std::ops::Range;

use predicament_contacts::checks::pairs::Seat;
use predicament_tasks::Contestant;
use rayon::prelude::*;

use super::{PolygonPair, Recipe, examine, random_pair};
use crate::Precision;

/// The counts under one [`Seat`] rule.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct SeatCounts {
    /// The number of pairs with an odd number of crossings.
    pub odd: usize,
    /// The number of pairs whose merged curves differ somewhere from the registrations, odd or not.
    ///
    /// (Registrations of perturbed curves say where the perturbed curves cross. If the unperturbed curves touch, the
    /// two differ.)
    pub unfaithful: usize,
}

/// The counts of one backend.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Row {
    /// The backend's name.
    pub backend: String,
    /// The number of pairs that it declined.
    pub declined: usize,
    /// The number of registrations by level: vertex-vertex, edge-vertex, edge-edge.
    pub registered: [usize; 3],
    /// The counts for each of [`Seat::ALL`].
    pub seats: [SeatCounts; 3],
    /// The number of pairs that are odd under some rule.
    pub odd_some: usize,
    /// The number of pairs that are odd under all rules.
    pub odd_all: usize,
    /// The number of pairs that are odd under some rule, by the registrations besides crossings.
    ///
    /// These are: nothing, vertices with vertices only, edges with vertices only, both.
    pub odd_with: [usize; 4],
    /// The number of pairs with a cluster.
    pub clustered: usize,
    /// The number of all clusters.
    pub clusters: usize,
    /// The largest number of vertices in a cluster.
    pub largest_cluster: usize,
    /// The number of clusters with a pair of vertices that were merged only through others.
    pub intransitive: usize,
    /// The number of pairs with a collapsed edge.
    pub collapsed: usize,
    /// The number of all collapsed edges.
    pub collapses: usize,
}

/// A pair with an odd number of crossings.
#[derive(Clone, PartialEq, Debug)]
pub struct Found {
    /// The recipe that made it.
    pub recipe: Recipe,
    /// The pair's number in the stream.
    pub number: u64,
    /// The backend that registered it.
    pub backend: String,
    /// The rules under which it is odd.
    pub seats: Vec<Seat>,
}

/// All counts of a search.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Census {
    /// The number of pairs of simple polygons.
    pub pairs: usize,
    /// The number of draws that were not simple polygons.
    pub refused: usize,
    /// The rows, one for each backend, in their order.
    pub rows: Vec<Row>,
    /// Every odd pair, in the order of the recipes and numbers.
    pub found: Vec<Found>,
}

/// Examines the random pairs of each recipe with these numbers under each backend.
///
/// The pairs are nearly degenerate for tolerances in this precision. The counts depend on nothing else.
#[must_use]
pub fn search(backends: &[&dyn Contestant], precision: Precision, seed: u64, numbers: Range<u64>) -> Census {
    let of_recipe = |recipe| numbers.clone().into_par_iter().map(move |number| (recipe, number));
    let one = |(recipe, number)| {
        let (pair, refused) = random_pair(recipe, precision, seed, number);
        let mut census = Census { pairs: 1, refused, ..Census::default() };
        for &backend in backends {
            census.take(backend, &pair, recipe, number);
        }
        census
    };
    Recipe::ALL.into_par_iter().flat_map(of_recipe).map(one).reduce(Census::default, Census::plus).sorted()
}

impl Census {
    /// The counts of two searches with different numbers, together.
    #[must_use]
    pub fn and(self, other: Census) -> Census {
        self.plus(other).sorted()
    }

    fn sorted(mut self) -> Census {
        self.found.sort_by(|f, g| (f.recipe, f.number, &f.backend).cmp(&(g.recipe, g.number, &g.backend)));
        self
    }

    fn take(&mut self, backend: &dyn Contestant, pair: &PolygonPair, recipe: Recipe, number: u64) {
        let mut row = Row { backend: backend.name(), ..Row::default() };
        if let Ok(examined) = examine(backend, pair) {
            for contact in &examined.contacts.registered {
                row.registered[usize::from(contact.a.rank + contact.b.rank)] += 1;
            }
            let seats = examined.crossings.each_ref().map(|crossings| SeatCounts {
                odd: usize::from(crossings.is_odd()),
                unfaithful: usize::from(!crossings.unfaithful.is_empty()),
            });
            let odd: Vec<Seat> = Seat::ALL.into_iter().zip(seats).filter(|(_, s)| s.odd > 0).map(|(s, _)| s).collect();
            row.seats = seats;
            row.odd_some = usize::from(!odd.is_empty());
            row.odd_all = usize::from(odd.len() == 3);
            if !odd.is_empty() {
                row.odd_with[usize::from(row.registered[0] > 0) + 2 * usize::from(row.registered[1] > 0)] = 1;
            }
            row.clustered = usize::from(!examined.clusters.is_empty());
            row.clusters = examined.clusters.len();
            let sizes = examined.clusters.iter().map(|cluster| cluster.vertices.iter().map(Vec::len).sum());
            row.largest_cluster = sizes.max().unwrap_or(0);
            row.intransitive = examined.clusters.iter().filter(|cluster| cluster.unregistered > 0).count();
            row.collapsed = usize::from(!examined.collapses.is_empty());
            row.collapses = examined.collapses.len();
            if !odd.is_empty() {
                self.found.push(Found { recipe, number, backend: backend.name(), seats: odd });
            }
        } else {
            row.declined = 1;
        }
        self.rows.push(row);
    }

    fn plus(mut self, other: Census) -> Census {
        if self.rows.is_empty() {
            self.rows = other.rows;
        } else {
            for (row, more) in self.rows.iter_mut().zip(other.rows) {
                row.add(&more);
            }
        }
        self.pairs += other.pairs;
        self.refused += other.refused;
        self.found.extend(other.found);
        self
    }
}

impl Row {
    fn add(&mut self, more: &Row) {
        for (level, count) in self.registered.iter_mut().zip(more.registered) {
            *level += count;
        }
        for (count, more) in self.odd_with.iter_mut().zip(more.odd_with) {
            *count += more;
        }
        for (seat, counts) in self.seats.iter_mut().zip(more.seats) {
            seat.odd += counts.odd;
            seat.unfaithful += counts.unfaithful;
        }
        self.declined += more.declined;
        self.odd_some += more.odd_some;
        self.odd_all += more.odd_all;
        self.clustered += more.clustered;
        self.clusters += more.clusters;
        self.largest_cluster = self.largest_cluster.max(more.largest_cluster);
        self.intransitive += more.intransitive;
        self.collapsed += more.collapsed;
        self.collapses += more.collapses;
    }
}
