//! A run beside an earlier one: what is worse.
//!
//! Findings count always. Times differ from machine to machine and from hour to hour, so they are judged only where somebody asks for
//! it, on the same machine, and beyond both the range of samples and a threshold.

use std::collections::{BTreeMap, BTreeSet};

use predicament_records::{Interface, RunDir, Spread, SummaryRow, ThroughputRow};
use predicament_tasks::Class;

use crate::exit::Failure;

/// What is worse than in an earlier run.
#[derive(Default)]
pub struct Worse {
    /// Rows with more of an illegal class than before.
    pub findings: Vec<String>,
    /// Scenes that have become slower; none where times were not judged.
    pub timings: Vec<String>,
    /// Whether times were judged, and why not; nothing where neither run has any.
    pub times: Option<Result<(), String>>,
    /// Timings of the run that were not held against the baseline though others were, each with the reason.
    pub not_compared: Vec<String>,
}

impl Worse {
    /// Holds a run against an earlier one. Times are judged where `percent` says from how much on they count.
    ///
    /// # Errors
    /// If the runs have nothing in common.
    pub fn than(run: &RunDir, baseline: &RunDir, percent: Option<f64>) -> Result<Worse, Failure> {
        comparable(run, baseline)?;
        let findings = more_findings(run, baseline);
        let then = timings(baseline);
        let in_common = timings(run).keys().any(|key| then.contains_key(key));
        let not_judged = |why: Option<String>| Worse { times: why.map(Err), ..Worse::default() };
        let worse = match percent {
            None => not_judged(in_common.then(|| "nobody asked: `--time` does".to_owned())),
            Some(_) if !in_common => not_judged(Some("the two have no timing in common".to_owned())),
            Some(percent) => match another_machine(run, baseline) {
                Some(why) => not_judged(Some(why)),
                None => slower(run, baseline, percent),
            },
        };
        Ok(Worse { findings, ..worse })
    }
}

/// In what the machines, or what the tool was compiled to there, differ; none if times can be compared.
fn another_machine(run: &RunDir, baseline: &RunDir) -> Option<String> {
    let pairs = run.env.comparable().into_iter().zip(baseline.env.comparable());
    let differing: Vec<String> = pairs
        .filter(|(now, then)| now != then)
        .map(|((what, now), (_, then))| format!("{what}: `{now}`, was `{then}`"))
        .collect();
    (!differing.is_empty())
        .then(|| format!("it was another machine, or another build for it ({})", differing.join("; ")))
}

/// Rows of the same scene and backend with more of an illegal class than before.
fn more_findings(run: &RunDir, baseline: &RunDir) -> Vec<String> {
    let before: BTreeMap<(&str, &str), &SummaryRow> =
        baseline.summary.iter().map(|row| ((row.scene_id.as_str(), row.backend.as_str()), row)).collect();
    let mut worse = Vec::new();
    for row in &run.summary {
        let Some(old) = before.get(&(row.scene_id.as_str(), row.backend.as_str())) else { continue };
        for class in Class::ALL.into_iter().filter(|class| !class.is_legal()) {
            let (now, then) = (row.count(class), old.count(class));
            if now > then {
                worse.push(format!(
                    "worse than the baseline: {}/{} on {}: {} {class}, was {then}",
                    row.suite, row.scene, row.backend, now
                ));
            }
        }
    }
    worse
}

/// Timings of a scene whose fastest sample is slower than the slowest sample of before,
/// and by so many percent at least: beyond what noise explains. A family of several scenes is compared scene by scene, as
/// those take different times; where it had other scenes, there is nothing to compare.
fn slower(run: &RunDir, baseline: &RunDir, percent: f64) -> Worse {
    let (now, then) = (timings(run), timings(baseline));
    let (scenes, scenes_then) = (scenes(run), scenes(baseline));
    let (mut slower, mut not_compared) = (Vec::new(), Vec::new());
    for (key @ ([task, family, backend], interface), now) in &now {
        let timed = format!("{task} {family} on {backend} ({interface})");
        let Some(then) = then.get(key) else {
            not_compared.push(format!("{timed}: the baseline has no timing of it"));
            continue;
        };
        let of = [*task, *family];
        if now.len() != then.len() || scenes.get(&of) != scenes_then.get(&of) {
            not_compared.push(format!("{timed}: other scenes were timed than in the baseline"));
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
    // Where nothing was compared, nothing was judged.
    let times = if not_compared.len() < timings(run).len() {
        Ok(())
    } else {
        Err(std::mem::take(&mut not_compared).join("; "))
    };
    Worse { timings: slower, times: Some(times), not_compared, ..Worse::default() }
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

/// Refuses a baseline that says nothing about this run.
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
