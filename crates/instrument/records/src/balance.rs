//! The distribution of scenes over the parts of a run, so that all parts take about as long.
//!
//! The maker of a plan computes the distribution once, in whole numbers, and writes it down. Parts on different
//! machines then agree without communication.

use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::{CostRow, Error, PlannedScene, Row};

/// The part, from 1 to `parts`, of the scene with this content id. It does not depend on the other selected scenes.
#[must_use]
pub fn part_of_id(id: &str, parts: u32) -> u32 {
    let digits = id.get(..15).unwrap_or(id);
    let number = u64::from_str_radix(digits, 16).unwrap_or(0);
    u32::try_from(number % u64::from(parts.max(1))).unwrap_or(0) + 1
}

/// The part, from 1, of each scene, given its id and its cost.
///
/// A scene without a cost goes to the part that its id gives. The other scenes are assigned in order, the most
/// expensive first and equal ones by id: each goes to the part with the smallest load so far, the first of several.
#[must_use]
pub fn balance(scenes: &[(&str, Option<u64>)], parts: u32) -> Vec<u32> {
    let mut assigned: Vec<u32> = scenes.iter().map(|(id, _)| part_of_id(id, parts)).collect();
    let mut order: Vec<(Reverse<u64>, &str, usize)> = Vec::new();
    for (at, &(id, cost)) in scenes.iter().enumerate() {
        order.extend(cost.map(|cost| (Reverse(cost), id, at)));
    }
    order.sort_unstable();
    let mut loads: BTreeMap<u32, u64> = (1..=parts).map(|part| (part, 0)).collect();
    for (Reverse(cost), _, at) in order {
        if let Some((part, load)) = loads.iter_mut().min_by_key(|(part, load)| (**load, **part)) {
            assigned[at] = *part;
            // A scene with cost 0 counts as 1: otherwise all such scenes would go to one part.
            *load = load.saturating_add(cost.max(1));
        }
    }
    assigned
}

/// The source of a scene's estimated cost.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Basis {
    /// Measured on every backend for this very scene.
    Measured,
    /// Estimated from scenes of the same task, by their cost per query.
    Estimated,
    /// Unknown.
    Unknown,
}

/// The costs of earlier runs, in microseconds.
#[derive(Clone, Default, Debug)]
pub struct Costs {
    /// The sum of costs and the number of runs, by scene and backend.
    scenes: BTreeMap<[String; 2], (u64, u64)>,
    /// Time and queries, by task, family and backend, and by task and backend with an empty family.
    rates: BTreeMap<[String; 3], (u64, u64)>,
}

impl Costs {
    /// The costs that these run folders contain.
    ///
    /// # Errors
    /// If a folder has no costs, or a line is wrong; the error names the folder or the line.
    pub fn read<P: AsRef<Path>>(folders: &[P]) -> Result<Costs, Error> {
        let mut costs = Costs::default();
        for folder in folders {
            let rows = CostRow::read(folder.as_ref())?;
            if rows.is_empty() {
                let message = format!(
                    "{} is missing: the folder is a bench, is not a run, or is from a version that did not measure \
                     costs; name a folder that `run` or `merge` wrote",
                    CostRow::FILE
                );
                return Err(Error::new(folder.as_ref(), message));
            }
            // If a scene was run again after a kill, its last cost counts.
            let last: BTreeMap<[&str; 3], &CostRow> =
                rows.iter().map(|row| ([&*row.scene_id, &*row.backend, &*row.suite], row)).collect();
            last.into_values().for_each(|row| costs.add(row));
        }
        Ok(costs)
    }

    fn add(&mut self, row: &CostRow) {
        // Wall time depends on the other load of the machine, so it is used only where processor time is unknown.
        let cost = if row.cpu_us == 0 { row.wall_us } else { row.cpu_us };
        let known = self.scenes.entry([row.scene_id.clone(), row.backend.clone()]).or_default();
        *known = (known.0.saturating_add(cost), known.1 + 1);
        for family in [&*row.family, ""] {
            let key = [row.task.clone(), family.to_owned(), row.backend.clone()];
            let rate = self.rates.entry(key).or_default();
            *rate = (rate.0.saturating_add(cost), rate.1.saturating_add(row.queries));
        }
    }

    /// The estimated cost of a scene on these backends together, and the source of the estimate.
    #[must_use]
    pub fn of(&self, scene: &PlannedScene, backends: &[String]) -> (Option<u64>, Basis) {
        let mut basis = Basis::Measured;
        let (mut sum, mut known, mut unknown) = (0_u64, 0_u64, 0_u64);
        for backend in backends.iter().map(String::as_str).chain([CostRow::TRUTH]) {
            if let Some((cost, runs)) = self.scenes.get(&[scene.scene_id.clone(), backend.to_owned()]) {
                (sum, known) = (sum.saturating_add(cost / runs), known + 1);
                continue;
            }
            basis = basis.max(Basis::Estimated);
            match self.rated(scene, backend) {
                Some(cost) => (sum, known) = (sum.saturating_add(cost), known + 1),
                None => unknown += 1,
            }
        }
        if known == 0 {
            return (None, Basis::Unknown);
        }
        // A backend without any known cost counts as the mean of the others.
        (Some(sum.saturating_add(sum / known * unknown)), basis)
    }

    /// The cost of the scene at the rate of its family, or else of its task.
    fn rated(&self, scene: &PlannedScene, backend: &str) -> Option<u64> {
        let rate = |family: &str| self.rates.get(&[scene.task.clone(), family.to_owned(), backend.to_owned()]);
        let (cost, queries) = rate(&scene.family).or_else(|| rate(""))?;
        let cost = u128::from(*cost) * u128::from(scene.queries) / u128::from((*queries).max(1));
        Some(u64::try_from(cost).unwrap_or(u64::MAX))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_id_is_in_exactly_one_part() {
        for parts in 1..6 {
            for i in 0..200_u64 {
                let id = format!("{:016x}", i.wrapping_mul(0x9e37_79b9_7f4a_7c15));
                assert!((1..=parts).contains(&part_of_id(&id, parts)), "{id} of {parts}");
            }
        }
        assert_eq!(part_of_id("0000000000000070", 7), 1, "seven");
        assert_eq!(part_of_id("no number", 7), 1);
    }

    #[test]
    fn the_longest_go_first_and_ties_by_id() {
        let scenes = [("c", Some(5)), ("a", Some(5)), ("b", Some(9)), ("d", Some(1)), ("e", Some(0)), ("f", Some(0))];
        // b (9) goes to 1; a (5) and c (5) go to 2; d (1) goes to 1; then both have 10.
        assert_eq!(balance(&scenes, 2), [2, 2, 1, 1, 1, 2]);
        let mut turned = scenes;
        turned.reverse();
        let mut expected = balance(&scenes, 2);
        expected.reverse();
        assert_eq!(balance(&turned, 2), expected, "the order does not matter");
        // Without costs the id decides, independently of the other scenes.
        let unknown = [("0000000000000070", None), ("b", Some(9))];
        assert_eq!(balance(&unknown, 7)[0], part_of_id("0000000000000070", 7));
        let loads = balance(&[("a", Some(0)), ("b", Some(0)), ("c", Some(0))], 3);
        assert_eq!(loads, [1, 2, 3]);
    }

    #[test]
    fn what_was_not_measured_is_estimated_by_its_family_and_then_its_task() {
        let scene = |id: &str, family: &str, queries: u64| {
            let text = |text: &str| text.to_owned();
            let (suite, scene, scene_id) = (text("s"), text(id), text(id));
            PlannedScene { suite, scene, scene_id, task: text("orient2d"), family: text(family), queries }
        };
        let mut costs = Costs::default();
        for (of, backend, cost) in [
            (scene("a", "near", 100), "exact", 1000),
            (scene("a", "near", 100), CostRow::TRUTH, 200),
            (scene("b", "far", 100), "exact", 3000),
            (scene("b", "far", 100), CostRow::TRUTH, 200),
        ] {
            costs.add(&CostRow::new(&of, backend, 9 * cost, cost));
        }
        let of = |scene: &PlannedScene, backends: &[&str]| {
            costs.of(scene, &backends.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>())
        };
        assert_eq!(of(&scene("a", "near", 100), &["exact"]), (Some(1200), Basis::Measured));
        assert_eq!(of(&scene("c", "near", 1000), &["exact"]), (Some(12_000), Basis::Estimated));
        assert_eq!(of(&scene("d", "wide", 100), &["exact"]), (Some(2200), Basis::Estimated));
        // `sos` has no known cost: it counts as the mean of the others.
        assert_eq!(of(&scene("a", "near", 100), &["exact", "sos"]), (Some(1800), Basis::Estimated));
        let other = PlannedScene { task: "hull2d".to_owned(), ..scene("e", "near", 9) };
        assert_eq!(of(&other, &["exact"]), (None, Basis::Unknown));
    }
}
