//! Rows brought together: errors and timings by task, family and backend.

use std::collections::{BTreeMap, BTreeSet};

use crate::{RunDir, Spread, SummaryRow};
use predicament_records::geometric_mean;

/// The control that every time is compared with: Shewchuk's adaptive
/// predicates, as most programs that care already use them.
pub const REFERENCE: &str = "shewchuk";

/// Task, family, backend.
pub type Key<'r> = [&'r str; 3];

/// Questions and wrong answers.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Errors {
    pub queries: u64,
    pub wrong: u64,
}

impl Errors {
    pub fn add(&mut self, row: &SummaryRow) {
        self.queries += row.queries;
        self.wrong += row.wrong();
    }
}

/// The errors of all runs together. Scenes without a family in the plan are left out.
pub fn errors(runs: &[RunDir]) -> BTreeMap<Key<'_>, Errors> {
    let mut errors: BTreeMap<Key, Errors> = BTreeMap::new();
    for run in runs {
        let families = run.plan.families();
        for row in run.summary.iter().filter(|row| row.has_answers()) {
            if let Some(family) = families.get(&[&*row.suite, &*row.scene, &*row.scene_id, &*row.task]) {
                errors.entry([&row.task, family, &row.backend]).or_default().add(row);
            }
        }
    }
    errors
}

/// The time of one query on one backend.
#[derive(Clone, PartialEq, Debug)]
pub struct Timing<'r> {
    /// Nanoseconds per query.
    pub spread: Spread,
    /// The engine's version, or versions.
    pub versions: BTreeSet<&'r str>,
}

/// The timings of one run.
pub fn timings(run: &RunDir) -> BTreeMap<Key<'_>, Timing<'_>> {
    let mut samples: BTreeMap<Key, (Vec<f64>, BTreeSet<&str>)> = BTreeMap::new();
    for row in &run.throughput {
        let (times, versions) = samples.entry([&row.task, &row.family, &row.backend]).or_default();
        times.push(row.ns_per_query);
        versions.insert(&row.engine_version);
    }
    let timing = |(key, (times, versions))| Some((key, Timing { spread: Spread::of(times)?, versions }));
    samples.into_iter().filter_map(timing).collect()
}

/// The backends of all runs: in the order of the plans, then the others by name.
pub fn backends(runs: &[RunDir]) -> Vec<&str> {
    let planned = runs.iter().flat_map(|run| &run.plan.backends).map(String::as_str);
    let rows: BTreeSet<&str> = runs
        .iter()
        .flat_map(|run| {
            let checked = run.summary.iter().map(|row| &*row.backend);
            let timed = run.throughput.iter().map(|row| &*row.backend);
            let staged = run.stages.iter().map(|row| &*row.backend);
            checked.chain(timed).chain(staged)
        })
        .collect();
    let mut seen = BTreeSet::new();
    planned.chain(rows).filter(|backend| seen.insert(*backend)).collect()
}

/// A backend on a task: its speed beside its errors, over the families for
/// which both are known.
#[derive(Clone, PartialEq, Debug)]
pub struct Mark<'r> {
    /// The place of the run with the timings in the list of runs.
    pub run: usize,
    pub task: &'r str,
    pub backend: &'r str,
    /// How many families are behind the mark.
    pub families: usize,
    /// Summed over the families.
    pub errors: Errors,
    /// The geometric mean of the families' medians, in nanoseconds per query.
    pub ns: f64,
    /// Whether no other backend is at least as good in both and better in one.
    pub on_frontier: bool,
}

/// What is known of a backend on one task and family.
struct Known<'r> {
    key: Key<'r>,
    errors: Errors,
    ns: f64,
}

/// All marks, by run, then task, then backend.
pub fn marks(runs: &[RunDir]) -> Vec<Mark<'_>> {
    let errors = errors(runs);
    let order = backends(runs);
    let rank = |backend: &str| order.iter().position(|b| *b == backend);
    let mut marks = Vec::new();
    for (run, timings) in runs.iter().map(timings).enumerate() {
        let mut groups: BTreeMap<(&str, Option<usize>), Vec<Known>> = BTreeMap::new();
        for (key, timing) in timings {
            if let Some(&errors) = errors.get(&key) {
                let known = Known { key, errors, ns: timing.spread.median };
                groups.entry((key[0], rank(key[2]))).or_default().push(known);
            }
        }
        for families in groups.values() {
            let (Some(first), Some(ns)) = (families.first(), geometric_mean(families.iter().map(|known| known.ns)))
            else {
                continue;
            };
            let [task, _, backend] = first.key;
            let errors = Errors {
                queries: families.iter().map(|known| known.errors.queries).sum(),
                wrong: families.iter().map(|known| known.errors.wrong).sum(),
            };
            marks.push(Mark { run, task, backend, families: families.len(), errors, ns, on_frontier: false });
        }
    }
    for i in 0..marks.len() {
        marks[i].on_frontier = !marks.iter().any(|other| dominates(other, &marks[i]));
    }
    marks
}

fn dominates(a: &Mark, b: &Mark) -> bool {
    // Rates as products, so that equal rates are equal whatever their denominators.
    let left = u128::from(a.errors.wrong) * u128::from(b.errors.queries);
    let right = u128::from(b.errors.wrong) * u128::from(a.errors.queries);
    (a.run, a.task) == (b.run, b.task) && left <= right && a.ns <= b.ns && (left < right || a.ns < b.ns)
}
