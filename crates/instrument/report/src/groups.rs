//! Timings grouped by task, family, backend and interface, and their ratios in pairs of backends.

use std::collections::{BTreeMap, BTreeSet};

use crate::{RunDir, Spread};
use predicament_records::{Interface, ThroughputRow, geometric_mean};

/// The control that every time is compared with: the plain determinant in doubles. So a ratio is the price of the
/// backend's extra work.
pub const REFERENCE: &str = "naive";

/// The interfaces by which times are compared. A batch that is a loop is compared with batches.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Way {
    Single,
    Batch,
    Whole,
}

impl Way {
    /// All three interfaces, in the order of columns.
    pub const ALL: [Way; 3] = [Way::Single, Way::Batch, Way::Whole];

    pub const fn of(interface: Interface) -> Way {
        match interface {
            Interface::Single => Way::Single,
            Interface::Batch | Interface::Loop => Way::Batch,
            Interface::Whole => Way::Whole,
        }
    }

    /// The interface's name in `figures.csv`.
    pub const fn name(self) -> &'static str {
        match self {
            Way::Single => "single",
            Way::Batch => "batch",
            Way::Whole => "whole",
        }
    }

    /// The head of the column with the times.
    pub const fn head(self) -> &'static str {
        match self {
            Way::Single => "single query",
            Way::Batch => "batch",
            Way::Whole => "whole scene",
        }
    }
}

/// The key of a timing: task, family, backend, and interface.
pub type Key<'r> = (&'r str, &'r str, &'r str, Way);

/// The time of one query on one backend.
#[derive(Clone, PartialEq, Debug)]
pub struct Timing<'r> {
    /// Nanoseconds per query. The ends are over all samples. The middle is the median of a scene's samples, or the
    /// geometric mean of these medians for several scenes.
    pub spread: Spread,
    /// The number of timed scenes.
    pub scenes: usize,
    /// True if the batches are loops over single queries.
    pub is_loop: bool,
    /// The engine's version, or versions.
    pub versions: BTreeSet<&'r str>,
}

/// The timings of one run.
///
/// Scenes have different times and numbers of samples. So a median over all samples of a family could belong to
/// different scenes on different backends.
pub fn timings(run: &RunDir) -> BTreeMap<Key<'_>, Timing<'_>> {
    let mut scenes: BTreeMap<Key<'_>, Vec<Vec<&ThroughputRow>>> = BTreeMap::new();
    for row in &run.throughput {
        let scenes = scenes.entry((&row.task, &row.family, &row.backend, Way::of(row.interface))).or_default();
        // The numbers of samples start from 0 for each scene.
        match scenes.last_mut().filter(|scene| scene.last().is_some_and(|last| row.sample > last.sample)) {
            Some(scene) => scene.push(row),
            None => scenes.push(vec![row]),
        }
    }
    scenes.into_iter().filter_map(|(key, scenes)| Some((key, timing(&scenes)?))).collect()
}

/// The timing of a backend on the scenes of a family.
fn timing<'r>(scenes: &[Vec<&'r ThroughputRow>]) -> Option<Timing<'r>> {
    let rows = || scenes.iter().flatten();
    let all = Spread::of(rows().map(|row| row.ns_per_query))?;
    let medians = scenes.iter().filter_map(|scene| Some(Spread::of(scene.iter().map(|row| row.ns_per_query))?.median));
    let median = if scenes.len() == 1 { all.median } else { geometric_mean(medians)? };
    let versions = rows().map(|row| &*row.engine_version).collect();
    let is_loop = rows().any(|row| row.interface == Interface::Loop);
    Some(Timing { spread: Spread { median, ..all }, scenes: scenes.len(), is_loop, versions })
}

/// The timings of several runs.
pub struct Times<'r> {
    runs: Vec<BTreeMap<Key<'r>, Timing<'r>>>,
    /// The number of scenes of a family, by run, task and family.
    planned: Vec<BTreeMap<[&'r str; 2], usize>>,
}

/// The time of a backend relative to a reference, by one interface.
#[derive(Clone, PartialEq, Debug)]
pub struct Pace {
    pub way: Way,
    /// The number of families, as pairs of task and family, on which both were timed.
    pub families: usize,
    /// The number of families on which the reference was timed.
    pub of: usize,
    /// The geometric mean of the backend's times over these families, in nanoseconds per query.
    pub ns: f64,
    /// The geometric means of the shortest and of the longest sample of each family.
    pub range: [f64; 2],
    /// The geometric mean of the reference's times.
    pub reference: f64,
    /// The geometric mean of the ratios.
    pub ratio: f64,
    /// True if the backend's batches are loops over single queries.
    pub is_loop: bool,
}

impl<'r> Times<'r> {
    pub fn of(runs: &'r [RunDir]) -> Times<'r> {
        let planned = |run: &'r RunDir| {
            let mut counts = BTreeMap::new();
            for scene in &run.plan.scenes {
                *counts.entry([&*scene.task, &*scene.family]).or_default() += 1;
            }
            counts
        };
        Times { runs: runs.iter().map(timings).collect(), planned: runs.iter().map(planned).collect() }
    }

    /// The tasks with timings.
    pub fn tasks(&self) -> BTreeSet<&'r str> {
        self.runs.iter().flat_map(|run| run.keys()).map(|(task, ..)| *task).collect()
    }

    /// The time of a backend relative to a reference on the tasks for which `keep` is true: over the families that both
    /// were timed on in one run, scene by scene. `None` if there is no such family.
    pub fn pace(&self, backend: &str, reference: &str, way: Way, keep: impl Fn(&str) -> bool) -> Option<Pace> {
        let mut of: BTreeSet<[&str; 2]> = BTreeSet::new();
        let mut pairs: BTreeMap<[&str; 2], Vec<[f64; 4]>> = BTreeMap::new();
        let mut is_loop = false;
        for (run, planned) in self.runs.iter().zip(&self.planned) {
            let of_reference =
                run.iter().filter(|((task, _, name, of), _)| *name == reference && *of == way && keep(task));
            for (&(task, family, ..), base) in of_reference {
                let is_whole =
                    |timing: &Timing| planned.get(&[task, family]).is_none_or(|&scenes| scenes == timing.scenes);
                if !is_whole(base) {
                    continue;
                }
                of.insert([task, family]);
                let timing = run.get(&(task, family, backend, way));
                if let Some(timing) = timing.filter(|timing| timing.scenes == base.scenes) {
                    let Spread { min, median, max, .. } = timing.spread;
                    is_loop |= timing.is_loop;
                    pairs.entry([task, family]).or_default().push([median, min, max, base.spread.median]);
                }
            }
        }
        // A family that was timed in several runs counts as one pair.
        let mean = |of: &dyn Fn(&[f64; 4]) -> f64| {
            geometric_mean(pairs.values().filter_map(|again| geometric_mean(again.iter().map(of))))
        };
        Some(Pace {
            way,
            families: pairs.len(),
            of: of.len(),
            ns: mean(&|times| times[0])?,
            range: [mean(&|times| times[1])?, mean(&|times| times[2])?],
            reference: mean(&|times| times[3])?,
            ratio: mean(&|times| times[0] / times[3])?,
            is_loop,
        })
    }

    /// The time of a backend relative to a reference on a task, by the first interface with times of both; batches come
    /// last.
    pub fn pace_on(&self, backend: &str, reference: &str, task: &str) -> Option<Pace> {
        let ways = [Way::Single, Way::Whole, Way::Batch];
        ways.into_iter().find_map(|way| self.pace(backend, reference, way, |of| of == task))
    }
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
