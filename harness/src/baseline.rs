//! A comparison of a run with an earlier run: what is worse and what is better.
//!
//! A class that became more frequent is worse; a class that became rarer is better. The other classes of the scene do
//! not matter, with one exception: if a broken scene is now only off by rounding, that is better, and the new rounding
//! findings are not worse.
//!
//! Findings are always compared. Times differ between machines and hours. They are compared only on request, on the
//! same machine, and a time is slower only beyond both the range of the samples and a threshold.

use std::collections::{BTreeMap, BTreeSet};

use predicament_predicates::{Class, Severity};
use predicament_records::{Interface, RunDir, Spread, SummaryRow, ThroughputRow};

use crate::exit::Failure;

/// A class of a row whose count changed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Change {
    /// The class.
    pub class: Class,
    /// `suite/scene on backend`.
    pub place: String,
    /// The count in the earlier run.
    pub then: u64,
    /// The count in this run.
    pub now: u64,
    /// True if the change is worse, false if it is better.
    pub is_worse: bool,
}

impl Change {
    /// The classes of a row whose counts changed, the worst severity first.
    pub fn of(old: &SummaryRow, new: &SummaryRow) -> Vec<Change> {
        let place = format!("{}/{} on {}", new.suite, new.scene, new.backend);
        let (mut changes, mut mended) = (Vec::new(), 0);
        for severity in Severity::ALL.into_iter().rev() {
            let classes = Class::ALL.into_iter().filter(|class| !class.is_legal() && class.severity() == severity);
            let mut rarer = 0;
            for class in classes {
                let (then, now) = (old.count(class), new.count(class));
                let instead = severity == Severity::Rounded && now.saturating_sub(then) <= mended;
                if now != then {
                    let is_worse = now > then && !instead;
                    changes.push(Change { class, place: place.clone(), then, now, is_worse });
                }
                rarer += then.saturating_sub(now);
            }
            if severity == Severity::Broken {
                mended = rarer;
            }
        }
        changes
    }
}

/// Writes one line, without a mark.
impl std::fmt::Display for Change {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Change { class, place, then, now, is_worse } = self;
        let severity = class.severity();
        match (is_worse, now) {
            (true, _) => write!(f, "worse than the baseline: {place}: {now} {class}, was {then} ({severity})"),
            (false, 0) => write!(f, "mended since the baseline: {place}: {class}, was {then} ({severity})"),
            (false, _) if now > then => {
                write!(f, "better than the baseline: {place}: {now} {class} instead of broken answers")
            }
            (false, _) => write!(f, "better than the baseline: {place}: {now} {class}, was {then} ({severity})"),
        }
    }
}

/// The comparison of a run with an earlier run.
#[derive(Default)]
pub struct Beside {
    /// Classes of rows that became more frequent, the worst severity first.
    pub worse: Vec<Change>,
    /// Classes of rows that became rarer or milder.
    pub better: Vec<Change>,
    /// Scenes that became slower; empty if times were not compared.
    pub timings: Vec<String>,
    /// `Ok` if times were compared, or the reason why not. `None` if times were not asked for and
    /// the runs have no timing in common.
    pub times: Option<Result<(), String>>,
    /// Timings of the run that were not compared although others were, each with the reason.
    pub not_compared: Vec<String>,
}

impl Beside {
    /// Compares a run with an earlier run. Times are compared if `percent`, the threshold, is given.
    ///
    /// # Errors
    /// If the runs have nothing in common.
    pub fn baseline(run: &RunDir, baseline: &RunDir, percent: Option<f64>) -> Result<Beside, Failure> {
        comparable(run, baseline)?;
        let (worse, better) = changes(run, baseline).into_iter().partition(|change| change.is_worse);
        let then = timings(baseline);
        let in_common = timings(run).keys().any(|key| then.contains_key(key));
        let not_judged = |why: Option<String>| Beside { times: why.map(Err), ..Beside::default() };
        let timed = match percent {
            None => not_judged(in_common.then(|| "not requested: add `--time`".to_owned())),
            Some(_) if !in_common => not_judged(Some("the runs have no timing in common".to_owned())),
            Some(percent) => match another_machine(run, baseline) {
                Some(why) => not_judged(Some(why)),
                None => slower(run, baseline, percent),
            },
        };
        Ok(Beside { worse, better, ..timed })
    }
}

/// The differences between the two machines or builds, or `None` if times can be compared.
fn another_machine(run: &RunDir, baseline: &RunDir) -> Option<String> {
    let pairs = run.env.comparable().into_iter().zip(baseline.env.comparable());
    let differing: Vec<String> = pairs
        .filter(|(now, then)| now != then)
        .map(|((what, now), (_, then))| format!("{what}: `{now}`, was `{then}`"))
        .collect();
    (!differing.is_empty()).then(|| format!("the machine or the build differs ({})", differing.join("; ")))
}

/// The changes in rows of the same scene and backend, the worst severity first.
fn changes(run: &RunDir, baseline: &RunDir) -> Vec<Change> {
    let before: BTreeMap<(&str, &str), &SummaryRow> =
        baseline.summary.iter().map(|row| ((row.scene_id.as_str(), row.backend.as_str()), row)).collect();
    let old = |row: &SummaryRow| before.get(&(row.scene_id.as_str(), row.backend.as_str())).copied();
    let mut changes: Vec<Change> =
        run.summary.iter().flat_map(|row| old(row).map(|old| Change::of(old, row)).unwrap_or_default()).collect();
    changes.sort_by_key(|change| std::cmp::Reverse(change.class.severity()));
    changes
}

/// Timings of scenes that became slower beyond noise.
/// A scene is slower if its fastest sample is slower than the slowest earlier sample, and its median is slower by at
/// least `percent`. A family of several scenes is compared scene by scene, because its scenes take different times. If
/// the family had other scenes in the earlier run, it is not compared.
fn slower(run: &RunDir, baseline: &RunDir, percent: f64) -> Beside {
    let (now, then) = (timings(run), timings(baseline));
    let (scenes, scenes_then) = (scenes(run), scenes(baseline));
    let (mut slower, mut not_compared) = (Vec::new(), Vec::new());
    for (key @ ([task, family, backend], interface), now) in &now {
        let timed = format!("{task} {family} on {backend} ({interface})");
        let Some(then) = then.get(key) else {
            not_compared.push(format!("{timed}: the baseline does not have this timing"));
            continue;
        };
        let of = [*task, *family];
        if now.len() != then.len() || scenes.get(&of) != scenes_then.get(&of) {
            not_compared.push(format!("{timed}: the baseline timed other scenes"));
            continue;
        }
        for (now, then) in now.iter().zip(then) {
            if now.min > then.max && now.median > (1.0 + percent / 100.0) * then.median {
                let times = now.median / then.median;
                slower.push(format!(
                    "slower: {timed}: {:.2} ns/query, was {:.2} ({times:.2} times)",
                    now.median, then.median
                ));
            }
        }
    }
    // If no timing was compared, times count as not judged.
    let times = if not_compared.len() < timings(run).len() {
        Ok(())
    } else {
        Err(std::mem::take(&mut not_compared).join("; "))
    };
    Beside { timings: slower, times: Some(times), not_compared, ..Beside::default() }
}

/// The timings of each scene, by task, family, backend and interface.
fn timings(run: &RunDir) -> BTreeMap<([&str; 3], Interface), Vec<Spread>> {
    let spread = |scene: &Vec<&ThroughputRow>| Spread::of(scene.iter().map(|row| row.ns_per_query));
    let by = |interface| {
        let scenes = run.timed_scenes_by(&[interface]).into_iter();
        scenes.map(move |(key, scenes)| ((key, interface), scenes.iter().filter_map(spread).collect()))
    };
    Interface::ALL.into_iter().flat_map(by).collect()
}

/// The scenes of each task and family, by id.
fn scenes(run: &RunDir) -> BTreeMap<[&str; 2], Vec<&str>> {
    let mut scenes: BTreeMap<_, Vec<_>> = BTreeMap::new();
    for scene in &run.plan.scenes {
        scenes.entry([&*scene.task, &*scene.family]).or_default().push(&*scene.scene_id);
    }
    scenes
}

/// Refuses a baseline that has no scene and no timing in common with this run.
fn comparable(run: &RunDir, baseline: &RunDir) -> Result<(), Failure> {
    let before: BTreeSet<&str> = baseline.plan.scenes.iter().map(|scene| scene.scene_id.as_str()).collect();
    let timed = || {
        let then = timings(baseline);
        timings(run).keys().any(|key| then.contains_key(key))
    };
    if run.plan.scenes.iter().any(|scene| before.contains(scene.scene_id.as_str())) || timed() {
        return Ok(());
    }
    Err(Failure::usage(format!(
        "{}: the baseline has no scene of this run, so nothing can be compared; name a run of the same suites",
        baseline.path.display()
    )))
}
