//! The search of all covers of a loop for one that is better than an answer.
//!
//! The edge from the first point to the last has one triangle in every triangulation. Each choice of its apex leaves
//! two smaller polygons. The search tries all choices, and leaves those whose least area is too large, those with a
//! triangle that cannot be in a cover, and those with two triangles that meet.

use std::collections::BTreeMap;

use predicament_predicates::Vertex;
use rug::Integer;

use super::{Areas, Around, Corners, Signs, is_flat, meet};

/// The work limit of a search, in choices of an apex and comparisons with triangles chosen before. A loop of n points
/// has at most C − 1 choices, where C is Catalan's number of n − 1. For eleven points these are 16,795 choices with at
/// most 8 comparisons each.
const MOST: usize = 160_000;

/// The result of a search.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Found {
    /// A cover.
    Cover(Vec<[Vertex; 3]>),
    /// There is none.
    Nothing,
    /// The search ended at its work limit.
    Undecided,
}

struct Hunt<'a> {
    signs: &'a Signs<'a>,
    surface: &'a Around,
    around: &'a [Vertex],
    areas: &'a Areas,
    /// A cover has a smaller area; every cover will do if there is no limit.
    limit: Option<Integer>,
    alone: BTreeMap<Corners, bool>,
    pairs: BTreeMap<[Corners; 2], bool>,
    chosen: Vec<Corners>,
    left: usize,
}

/// Searches for a cover with an area below a limit, if there is one: a disk with no triangle without area, no edge of
/// the surface, and no crossing.
#[must_use]
pub fn hunt(signs: &Signs<'_>, surface: &Around, around: &[Vertex], areas: &Areas, limit: Option<Integer>) -> Found {
    let (alone, pairs, chosen) = (BTreeMap::new(), BTreeMap::new(), Vec::new());
    let mut hunt = Hunt { signs, surface, around, areas, limit, alone, pairs, chosen, left: MOST };
    let whole = [0, around.len() - 1];
    match hunt.choose(&mut vec![whole], &areas.least(whole).clone()) {
        Some(true) => Found::Cover(hunt.chosen.iter().map(|corners| corners.map(|at| around[at])).collect()),
        Some(false) => Found::Nothing,
        None => Found::Undecided,
    }
}

impl Hunt<'_> {
    /// True if the open polygons can be completed; `least` is a lower bound of the area. `None` at the work limit.
    fn choose(&mut self, open: &mut Vec<[usize; 2]>, least: &Integer) -> Option<bool> {
        let Some([i, k]) = open.pop() else { return Some(true) };
        if k - i == 1 {
            let is_found = self.choose(open, least);
            open.push([i, k]);
            return is_found;
        }
        let without = Integer::from(least - self.areas.least([i, k]));
        for j in i + 1..k {
            self.left = self.left.checked_sub(1 + self.chosen.len())?;
            let corners = [i, j, k];
            let beyond = Integer::from(self.areas.least([i, j]) + self.areas.least([j, k]));
            let bound = Integer::from(&without + self.areas.twice(corners)) + beyond;
            if self.limit.as_ref().is_some_and(|limit| bound >= *limit) || !self.fits(corners) {
                continue;
            }
            self.chosen.push(corners);
            open.extend([[i, j], [j, k]]);
            if self.choose(open, &bound)? {
                return Some(true);
            }
            open.truncate(open.len() - 2);
            self.chosen.pop();
        }
        open.push([i, k]);
        Some(false)
    }

    /// True if a triangle can be in a cover with those chosen.
    fn fits(&mut self, corners: Corners) -> bool {
        let known = self.alone.get(&corners).copied();
        let is_good = known.unwrap_or_else(|| self.is_good(corners));
        self.alone.insert(corners, is_good);
        is_good
            && !self.chosen.iter().any(|&other| {
                let [t, u] = [corners, other].map(|corners| corners.map(|at| self.around[at]));
                *self.pairs.entry([corners, other]).or_insert_with(|| meet(self.signs, t, u))
            })
    }

    fn is_good(&self, [a, b, c]: Corners) -> bool {
        let n = self.around.len();
        let is_used = |[from, to]: [usize; 2]| {
            (2..n - 1).contains(&(to - from)) && self.surface.has_edge([self.around[from], self.around[to]])
        };
        let triangle = [a, b, c].map(|at| self.around[at]);
        !([[a, b], [b, c], [a, c]].into_iter().any(is_used)
            || is_flat(self.signs, triangle)
            || self.surface.met(self.signs, triangle).is_some())
    }
}
