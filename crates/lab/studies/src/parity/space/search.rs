//! A search through many pairs under several backends, with counts by recipe.

use std::collections::BTreeMap;
use std::ops::Range;

use predicament_tasks::Contestant;
use rayon::prelude::*;

use super::{Broken, Recipe, SurfacePair, examine, random_surfaces};
use crate::Precision;

/// The counts of one recipe and backend.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Row {
    /// The number of pairs of embedded surfaces.
    pub pairs: usize,
    /// The number of draws that were not embedded.
    pub refused: usize,
    /// The number of pairs that the backend declined.
    pub declined: usize,
    /// The number of registrations by level, the sum of the ranks.
    pub registered: [usize; 4],
    /// The number of broken pairs, for each of [`Broken::ALL`].
    pub broken: [usize; 3],
    /// The number of pairs with loose ends: curves without a continuation or a direction.
    pub loose: usize,
    /// The number of pairs that are broken in some way.
    pub some: usize,
    /// The number of broken pairs with piercings and no degenerate registration.
    pub piercings_alone: usize,
    /// The number of all loose ends.
    pub ends: usize,
    /// The number of pieces of intersection curves.
    pub pieces: usize,
    /// The number of triangle boundaries checked against the law.
    pub boundaries: usize,
    /// The number of boundaries with a degenerate contact, which were not checked.
    pub degenerate: usize,
}

impl Row {
    fn add(&mut self, more: &Row) {
        let each = |of: &mut [usize], more: &[usize]| of.iter_mut().zip(more).for_each(|(count, more)| *count += more);
        each(&mut self.registered, &more.registered);
        each(&mut self.broken, &more.broken);
        let fields = |row: &Row| {
            let [pairs, refused, declined, loose, some] = [row.pairs, row.refused, row.declined, row.loose, row.some];
            [
                pairs,
                refused,
                declined,
                loose,
                some,
                row.piercings_alone,
                row.ends,
                row.pieces,
                row.boundaries,
                row.degenerate,
            ]
        };
        let mut sums = fields(self);
        each(&mut sums, &fields(more));
        [
            self.pairs,
            self.refused,
            self.declined,
            self.loose,
            self.some,
            self.piercings_alone,
            self.ends,
            self.pieces,
            self.boundaries,
            self.degenerate,
        ] = sums;
    }
}

/// A broken pair.
#[derive(Clone, PartialEq, Debug)]
pub struct Found {
    /// The recipe that made it.
    pub recipe: Recipe,
    /// The pair's number in the stream.
    pub number: u64,
    /// The index of the backend that registered it.
    pub backend: usize,
    /// The ways in which the pair is broken.
    pub ways: Vec<Broken>,
}

/// All counts of a search.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Census {
    /// The backends' names, in their order.
    pub backends: Vec<String>,
    /// The rows, by recipe and index of the backend.
    pub rows: BTreeMap<(Recipe, usize), Row>,
    /// Every broken pair, in the order of recipes, numbers and backends.
    pub found: Vec<Found>,
}

/// Examines the random pairs of each recipe with these numbers under each backend.
///
/// The pairs are nearly degenerate for tolerances in this precision. The counts depend on nothing else.
#[must_use]
pub fn search(backends: &[&dyn Contestant], precision: Precision, seed: u64, numbers: Range<u64>) -> Census {
    let of_recipe = |recipe| numbers.clone().into_par_iter().map(move |number| (recipe, number));
    let one = |(recipe, number)| {
        let (pair, refused) = random_surfaces(recipe, precision, seed, number);
        let mut census = Census::of(backends);
        for (place, backend) in backends.iter().enumerate() {
            let row = Row { pairs: 1, refused, ..Row::default() };
            census.take((recipe, place), row, *backend, &pair, number);
        }
        census
    };
    let all = Recipe::ALL.into_par_iter().flat_map(of_recipe).map(one);
    all.reduce(|| Census::of(backends), Census::plus).sorted()
}

impl Census {
    fn of(backends: &[&dyn Contestant]) -> Census {
        Census { backends: backends.iter().map(|backend| backend.name()).collect(), ..Census::default() }
    }

    /// The counts of two searches with different numbers and the same backends, together.
    #[must_use]
    pub fn and(self, other: Census) -> Census {
        self.plus(other).sorted()
    }

    fn sorted(mut self) -> Census {
        self.found.sort_by_key(|found| (found.recipe, found.number, found.backend));
        self
    }

    fn take(
        &mut self,
        (recipe, place): (Recipe, usize),
        mut row: Row,
        backend: &dyn Contestant,
        pair: &SurfacePair,
        number: u64,
    ) {
        if let Ok(examined) = examine(backend, pair) {
            for contact in &examined.contacts.registered {
                row.registered[usize::from(contact.a.rank + contact.b.rank)] += 1;
            }
            let ways = examined.broken();
            row.broken = Broken::ALL.map(|way| usize::from(ways.contains(&way)));
            row.loose = usize::from(!examined.ends.loose.is_empty());
            row.some = usize::from(!ways.is_empty());
            row.piercings_alone = usize::from(!ways.is_empty() && row.registered[..3] == [0; 3]);
            row.ends = examined.ends.loose.len();
            row.pieces = examined.ends.pieces;
            row.boundaries = examined.boundaries.checked;
            row.degenerate = examined.boundaries.degenerate;
            if !ways.is_empty() {
                self.found.push(Found { recipe, number, backend: place, ways });
            }
        } else {
            row.declined = 1;
        }
        self.rows.insert((recipe, place), row);
    }

    fn plus(mut self, other: Census) -> Census {
        if self.backends.is_empty() {
            self.backends = other.backends;
        }
        for (key, row) in &other.rows {
            self.rows.entry(*key).or_default().add(row);
        }
        self.found.extend(other.found);
        self
    }
}
