//! Moves from one scene to another.
//!
//! Moves do not depend on the task: a scene is rows of coordinates, and items that name vertices. If a move makes an
//! invalid scene of the task, reading its text refuses it. Derivation from an interesting scene beats random points.
//! Most moves keep the property that makes it interesting (a scaling, a rotation by a Pythagorean triple), or change
//! only the last bits.

mod numbers;
mod places;
mod structure;
mod whole;

pub(super) use structure::MOST_ROWS;

use predicament_corpus::{Random, Spelled};

use crate::rows::width;

/// A scene during a change.
pub(super) struct Draft<'a> {
    pub spelled: Spelled,
    /// Another scene, for recombination.
    pub mate: Option<&'a Spelled>,
    pub random: &'a mut Random,
}

/// A move; returns true if it changed anything.
type Move = fn(&mut Draft<'_>) -> bool;

/// All moves, with their relative frequencies.
const MOVES: [(&str, u32, Move); 30] = [
    ("ulps", 12, numbers::ulps),
    ("beside a power of two", 3, numbers::beside_power),
    ("half an ulp", 3, numbers::half_ulp),
    ("fewer bits", 3, numbers::fewer_bits),
    ("another's coordinate", 4, numbers::copied),
    ("nearer", 3, numbers::nearer),
    ("other sign", 2, numbers::negated),
    ("another exponent", 3, numbers::exponent),
    ("onto a point", 4, places::onto_point),
    ("near a point", 4, places::near_point),
    ("onto a line", 8, places::onto_line),
    ("near a line", 4, places::near_line),
    ("onto a plane", 5, places::onto_plane),
    ("onto a circle or sphere", 6, places::onto_sphere),
    ("parallelogram", 3, places::parallelogram),
    ("all scaled", 5, whole::scaled),
    ("an axis scaled", 3, whole::axis_scaled),
    ("a point scaled", 3, whole::point_scaled),
    ("far away", 3, whole::far_away),
    ("a point to the origin", 2, whole::to_origin),
    ("Pythagorean turn", 5, whole::turned),
    ("sheared", 3, whole::sheared),
    ("axes exchanged", 2, whole::axes_exchanged),
    ("onto a grid", 4, whole::onto_grid),
    ("arguments exchanged", 4, structure::arguments_exchanged),
    ("points exchanged", 3, structure::points_exchanged),
    ("another vertex", 3, structure::other_vertex),
    ("a point twice", 3, structure::point_twice),
    ("an item twice", 2, structure::item_twice),
    ("a point less", 2, structure::point_less),
];

/// Moves that need another scene.
const RECOMBINING: [(&str, u32, Move); 3] = [
    ("points of another", 3, structure::points_of_mate),
    ("an axis of another", 2, structure::axis_of_mate),
    ("beside another", 1, structure::beside_mate),
];

impl Draft<'_> {
    /// Makes one to four moves; returns the names of the effective ones.
    pub(super) fn change(&mut self) -> Vec<&'static str> {
        let mut names = Vec::new();
        if self.mate.is_some() {
            names.extend(self.try_one(&RECOMBINING));
        }
        let mut wanted = 1;
        while wanted < 4 && self.random.one_in(3) {
            wanted += 1;
        }
        let mut tries = 0;
        while names.len() < wanted && tries < 20 {
            names.extend(self.try_one(&MOVES));
            tries += 1;
        }
        names
    }

    fn try_one(&mut self, moves: &[(&'static str, u32, Move)]) -> Option<&'static str> {
        let total: u32 = moves.iter().map(|(_, weight, _)| weight).sum();
        let mut at = u32::try_from(self.random.integer(1, i64::from(total))).unwrap_or(1);
        let (name, _, change) = moves.iter().find(|(_, weight, _)| {
            let found = at <= *weight;
            at = at.saturating_sub(*weight);
            found
        })?;
        let before = self.spelled.clone();
        let changed = change(self) && self.spelled.rows().into_iter().flatten().all(|x| x.is_finite());
        if !changed {
            self.spelled = before;
        }
        changed.then_some(name)
    }

    /// A random number below `n`; `n` is not zero.
    fn below(&mut self, n: usize) -> usize {
        let most = i64::try_from(n.max(1)).unwrap_or(i64::MAX) - 1;
        usize::try_from(self.random.integer(0, most)).unwrap_or_default()
    }

    /// The number of rows of coordinates.
    fn rows(&self) -> usize {
        self.spelled.rows().len()
    }

    /// A row, by its index.
    fn row(&self, at: usize) -> Vec<f64> {
        self.spelled.rows()[at].clone()
    }

    /// Replaces a row by another, along as many axes as both have.
    fn put(&mut self, at: usize, row: &[f64]) -> bool {
        let Some(place) = self.spelled.rows_mut().nth(at) else { return false };
        let mut changed = false;
        for (x, &new) in place.iter_mut().zip(row) {
            changed |= x.to_bits() != new.to_bits();
            *x = new;
        }
        changed
    }

    /// A random row and its index; `None` if there are no coordinates.
    fn pick(&mut self) -> Option<(usize, Vec<f64>)> {
        let rows = self.rows();
        if rows == 0 {
            return None;
        }
        let at = self.below(rows);
        let row = self.row(at);
        (!row.is_empty()).then_some((at, row))
    }

    /// Another row with the same number of coordinates, most often at a different position; `None` if there is no such
    /// row.
    fn another(&mut self, length: usize, besides: &[usize]) -> Option<(usize, Vec<f64>)> {
        let all: Vec<usize> = {
            let rows = self.spelled.rows();
            (0..rows.len()).filter(|at| rows[*at].len() == length && !besides.contains(at)).collect()
        };
        if all.is_empty() {
            return None;
        }
        let at = all[self.below(all.len())];
        Some((at, self.row(at)))
    }

    /// Changes every coordinate; returns true if any coordinate is different.
    fn each(&mut self, change: impl Fn(usize, f64) -> f64) -> bool {
        let mut changed = false;
        let widths: Vec<usize> = self.spelled.rows().iter().map(|row| width(&self.spelled, row.len())).collect();
        for (row, width) in self.spelled.rows_mut().zip(widths) {
            for (at, x) in row.iter_mut().enumerate() {
                let new = change(at % width, *x);
                changed |= new.to_bits() != x.to_bits();
                *x = new;
            }
        }
        changed
    }

    /// A number of magnitude at most one half, of any size down to 2^-`bits`.
    fn small(&mut self, bits: i64) -> f64 {
        let exponent = self.random.integer(0, bits);
        (self.random.unit() - 0.5) * predicament_formats::bits::power_of_two(-exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use predicament_corpus::{Items, List};
    use predicament_predicates::Vertex;

    fn scene() -> Spelled {
        let ids = |ids: &[usize]| ids.iter().map(|&at| Vertex::input(at)).collect::<Vec<_>>();
        Spelled {
            task: "orient2d",
            points: vec![vec![0.0, 0.0], vec![4.0, 1.0], vec![1.0, 3.0], vec![-2.0, 5.0]],
            lists: vec![List::required("queries", Items::Tuples(vec![ids(&[0, 1, 2]), ids(&[1, 2, 3])]))],
            ..Spelled::default()
        }
    }

    /// Checks each move of the list: it changes a plain scene, gives the same result for the same seed, keeps
    /// coordinates finite and vertices in range.
    #[test]
    fn every_move_changes_a_scene() {
        let scene =
            || Spelled { points: vec![vec![0.3, 0.7], vec![4.1, 1.9], vec![1.7, 3.3], vec![-2.9, 5.1]], ..scene() };
        let mate = Spelled { points: vec![vec![9.0, 7.0]; 4], ..scene() };
        for (name, _, change) in MOVES.into_iter().chain(RECOMBINING) {
            let run = |seed| {
                let mut random = Random::new("hunt", name, seed);
                let mut draft = Draft { spelled: scene(), mate: Some(&mate), random: &mut random };
                let changed = change(&mut draft);
                (changed, draft.spelled)
            };
            let all: Vec<(bool, Spelled)> = (0..30).map(run).collect();
            assert!(all.iter().any(|(changed, moved)| *changed && *moved != scene()), "{name}");
            for (seed, (_, moved)) in all.iter().enumerate() {
                assert_eq!(run(seed as u64).1, *moved, "{name}");
                let points = moved.points.len();
                let Items::Tuples(tuples) = &moved.lists[0].items else { panic!("{name}") };
                assert!(tuples.iter().flatten().all(|v| v.index() < points), "{name}");
            }
        }
    }

    /// Tests the smallest doubles, the largest, and both in one scene.
    #[test]
    fn no_move_minds_the_ends_of_the_range() {
        let ends = [f64::from_bits(1), -f64::from_bits(7), f64::MAX, -f64::MAX / 3.0, 0.0];
        for (name, _, change) in MOVES.into_iter().chain(RECOMBINING) {
            for seed in 0..60 {
                let mut random = Random::new("hunt", name, seed);
                let kinds = [&ends[..2], &ends[2..4], &ends[..]][usize::try_from(seed % 3).unwrap()];
                let mut points = vec![vec![0.0; 2]; 4];
                for x in points.iter_mut().flatten() {
                    *x = kinds[usize::try_from(random.integer(0, 9)).unwrap() % kinds.len()];
                }
                let mate = Spelled { points, ..scene() };
                let mut draft = Draft { spelled: mate.clone(), mate: Some(&mate), random: &mut random };
                draft.try_one(&[(name, 1, change)]);
                assert!(draft.spelled.rows().into_iter().flatten().all(|x| x.is_finite()), "{name}");
            }
        }
    }

    #[test]
    fn what_is_exact_stays_exact() {
        let moved = |change: Move, seed| {
            let mut random = Random::new("hunt", "exact", seed);
            let mut draft = Draft { spelled: scene(), mate: None, random: &mut random };
            change(&mut draft);
            draft.spelled.points
        };
        let length = |p: &[f64], q: &[f64]| p.iter().zip(q).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
        for seed in 0..20 {
            let turned = moved(whole::turned, seed);
            let ratio = length(&turned[0], &turned[1]) / 17.0;
            assert_eq!(length(&turned[0], &turned[2]), ratio * 10.0, "a turn keeps the ratios of lengths");
            assert_eq!(ratio.sqrt().fract(), 0.0, "{turned:?}");
        }
    }
}
