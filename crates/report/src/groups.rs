//! Errors and timings grouped by task, family and backend.

use std::collections::{BTreeMap, BTreeSet};

use crate::{Class, RunDir, Spread, SummaryRow};
use predicament_records::{ThroughputRow, geometric_mean};

/// The control that every time is compared with: Shewchuk's adaptive
/// predicates, as most programs that care already use them.
pub const REFERENCE: &str = "shewchuk";

/// Task, family, backend.
pub type Key<'r> = [&'r str; 3];

/// Task and family: the least that backends are compared on.
pub type Pair<'r> = [&'r str; 2];

/// What is known of each backend, by task and family.
pub type ByPair<'r, T> = BTreeMap<Pair<'r>, BTreeMap<&'r str, T>>;

/// Questions, wrong answers and failed checks.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Errors {
    pub queries: u64,
    pub wrong: u64,
    /// Failed checks of whole scenes, panics and timeouts.
    pub failed: u64,
}

impl Errors {
    /// Adds what one row counts.
    pub fn add(&mut self, row: &SummaryRow) {
        self.queries += row.queries;
        self.wrong += row.wrong();
        self.failed +=
            [Class::Topology, Class::Panic, Class::Timeout].map(|class| row.count(class)).iter().sum::<u64>();
    }

    /// The sum of several.
    pub fn sum(all: impl IntoIterator<Item = Errors>) -> Errors {
        all.into_iter().fold(Errors::default(), |a, b| Errors {
            queries: a.queries + b.queries,
            wrong: a.wrong + b.wrong,
            failed: a.failed + b.failed,
        })
    }

    /// Whether there was no mistake.
    pub fn is_right(&self) -> bool {
        self.wrong == 0 && self.failed == 0
    }
}

/// The errors of the answers to the scenes that these runs have planned, wherever they were judged: of each family, of the
/// backends that answered every scene of it that any backend answered.
pub fn answered<'r>(runs: &'r [RunDir], planned: &[&'r RunDir]) -> ByPair<'r, Errors> {
    let families: BTreeMap<_, _> = planned.iter().flat_map(|run| run.plan.families()).collect();
    let mut found: ByPair<(BTreeSet<[&str; 3]>, Errors)> = BTreeMap::new();
    for row in runs.iter().flat_map(|run| &run.summary).filter(|row| row.has_answers()) {
        if let Some(family) = families.get(&[&*row.suite, &*row.scene, &*row.scene_id, &*row.task]) {
            let (scenes, errors) = found.entry([&row.task, family]).or_default().entry(&row.backend).or_default();
            scenes.insert([&*row.suite, &*row.scene, &*row.scene_id]);
            errors.add(row);
        }
    }
    let whole = |backends: BTreeMap<&'r str, (BTreeSet<[&str; 3]>, Errors)>| {
        let all = backends.values().flat_map(|(scenes, _)| scenes).collect::<BTreeSet<_>>().len();
        let whole = backends.iter().filter(|(_, (scenes, _))| scenes.len() == all);
        whole.map(|(&backend, &(_, errors))| (backend, errors)).collect()
    };
    found.into_iter().map(|(pair, backends)| (pair, whole(backends))).collect()
}

/// The time of one query on one backend.
#[derive(Clone, PartialEq, Debug)]
pub struct Timing<'r> {
    /// Nanoseconds per query: the ends over all samples; in the middle the median of a scene's samples, or
    /// of several scenes the geometric mean of their medians.
    pub spread: Spread,
    /// How many scenes were timed.
    pub scenes: usize,
    /// The engine's version, or versions.
    pub versions: BTreeSet<&'r str>,
}

/// The timings of one run. Scenes take different times and numbers of samples, so that a median over those of a family
/// would be of one scene here and of another there.
pub fn timings(run: &RunDir) -> BTreeMap<Key<'_>, Timing<'_>> {
    let timed = run.timed_scenes().into_iter();
    timed.filter_map(|(key, scenes)| Some((key, timing(&scenes)?))).collect()
}

/// The timing of a backend on the scenes of a family.
fn timing<'r>(scenes: &[Vec<&'r ThroughputRow>]) -> Option<Timing<'r>> {
    let rows = || scenes.iter().flatten();
    let all = Spread::of(rows().map(|row| row.ns_per_query))?;
    let medians = scenes.iter().filter_map(|scene| Some(Spread::of(scene.iter().map(|row| row.ns_per_query))?.median));
    let median = if scenes.len() == 1 { all.median } else { geometric_mean(medians)? };
    let versions = rows().map(|row| &*row.engine_version).collect();
    Some(Timing { spread: Spread { median, ..all }, scenes: scenes.len(), versions })
}

/// The nanoseconds per query of one run: of each family, of the backends that were timed on as many scenes as any.
pub fn timed(run: &RunDir) -> ByPair<'_, Spread> {
    let mut found: ByPair<Timing> = BTreeMap::new();
    for ([task, family, backend], timing) in timings(run) {
        found.entry([task, family]).or_default().insert(backend, timing);
    }
    let whole = |backends: BTreeMap<_, Timing<'_>>| {
        let all = backends.values().map(|timing| timing.scenes).max();
        let whole = backends.into_iter().filter(|(_, timing)| Some(timing.scenes) == all);
        whole.map(|(backend, timing)| (backend, timing.spread)).collect()
    };
    found.into_iter().map(|(pair, backends)| (pair, whole(backends))).collect()
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
