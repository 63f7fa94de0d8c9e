//! All backends on all scenes of an input: classes and checks, errors of contacts, time and memory.

use std::collections::{BTreeMap, BTreeSet};

use predicament_contacts::task::Complexes;
use predicament_corpus::LoadedScene;
use predicament_predicates::{Counts, Severity};
use predicament_records::{Spread, approximately};
use predicament_tasks::{AnyTask, Budget, Class, ClassCounts, Contestant, How, Outcome, Purpose, Watch, run};
use rayon::prelude::*;

use super::bits::bits;
use super::clock::taken;
use super::errors::{Errors, exact_places, tail};
use super::inputs::Input;
use super::measure::{About, Measure};
use super::standing::{ASKED_TWICE, REFERENCE, TWICE};
use crate::{Error, Host};

/// The results of a backend on all scenes of an input.
#[derive(Default)]
struct Seen {
    scenes: u64,
    counts: ClassCounts,
    declined: u64,
    /// The number of scenes by the worst class of their answers, in the order of [`Severity::ALL`].
    worst: [u64; Severity::ALL.len()],
    /// The number of scenes with a topology finding, by check.
    checks: BTreeMap<String, u64>,
    broken: u64,
    errors: Errors,
    /// The number of queries by the stage that settled them.
    stages: BTreeMap<&'static str, u64>,
    /// The largest bits, and the numbers of scenes whose bits are known and unknown.
    bits: (i32, u64, u64),
}

impl Seen {
    fn add(&mut self, outcome: &Outcome, bits: Option<i32>) {
        self.scenes += 1;
        let worst = worst(outcome);
        self.worst[worst as usize] += 1;
        if matches!(worst, Severity::NotDone | Severity::Refused) {
            self.declined += u64::from(outcome.counts.get(Class::Declined) > 0);
            return;
        }
        match bits {
            Some(bits) => self.bits = (self.bits.0.max(bits), self.bits.1 + 1, self.bits.2),
            None => self.bits.2 += 1,
        }
        self.counts.merge(&outcome.counts);
        let topology = outcome.findings.iter().filter(|finding| finding.class == Class::Topology);
        let mut checks: Vec<&str> = topology.map(|finding| finding.check.as_str()).collect();
        checks.sort_unstable();
        checks.dedup();
        self.broken += u64::from(!checks.is_empty());
        for check in checks {
            *self.checks.entry(check.to_owned()).or_default() += 1;
        }
        for &(stage, count) in &outcome.stages {
            *self.stages.entry(stage).or_default() += count;
        }
    }
}

/// The severity of the worst class of a scene; `Right` if it has no class.
fn worst(outcome: &Outcome) -> Severity {
    let seen = Class::ALL.into_iter().filter(|&class| outcome.counts.get(class) > 0);
    seen.map(Class::severity).max().unwrap_or(Severity::Right)
}

/// The measures of all backends on an input, in the order of the backends.
pub(super) fn measures(
    input: &Input,
    backends: &[&dyn Contestant],
    [scenes, samples]: [u32; 2],
    seed: u64,
    host: &dyn Host,
) -> Result<Vec<Measure>, Error> {
    let watch = host.watch();
    let mut loaded: Vec<LoadedScene> =
        (0..u64::from(scenes)).map(|at| input.scene(seed + at)).collect::<Result<_, Error>>()?;
    // A deterministic family makes one scene.
    let mut known = BTreeSet::new();
    loaded.retain(|scene| known.insert(scene.id.clone()));
    let timed = (samples > 0).then(|| input.timed(seed)).transpose()?;
    let group = Group { task: input.task, kind: input.of.kind.name(), family: input.of.family };
    let mut all = measures_of(&group, &loaded, timed.as_ref(), backends, samples, watch)?;
    if let Some(timed) = &timed {
        all.extend(asked_twice(&group, timed, backends, samples, host)?);
    }
    Ok(all)
}

/// The reference's slowdown if it computes each answer twice; empty without the reference.
fn asked_twice(
    group: &Group<'_>,
    timed: &LoadedScene,
    backends: &[&dyn Contestant],
    samples: u32,
    host: &dyn Host,
) -> Result<Option<Measure>, Error> {
    let Some(&reference) = backends.iter().find(|backend| backend.name() == REFERENCE) else { return Ok(None) };
    let twice = host.backend(TWICE)?;
    let taken = taken(timed, &[reference, twice.as_ref()], samples, host.watch())?;
    let [Some(once), Some(twice)] = [0, 1].map(|at: usize| Spread::of(taken[at].nanoseconds.iter().copied())) else {
        return Ok(None);
    };
    let about = About { task: group.task.name(), kind: group.kind, family: group.family, backend: REFERENCE };
    // Disturbances make a sample longer: the shortest samples are compared.
    let ends = [twice.min / once.max, twice.max / once.min];
    Ok(Some(about.measure(ASKED_TWICE, "times the time", twice.min / once.min, ends, twice.samples as u64)))
}

/// The common columns of measures of some scenes.
pub(crate) struct Group<'a> {
    pub task: &'static dyn AnyTask,
    pub kind: &'a str,
    pub family: &'a str,
}

/// The measures of all backends on these scenes; times and memory are of one scene.
pub(crate) fn measures_of(
    group: &Group<'_>,
    loaded: &[LoadedScene],
    timed: Option<&LoadedScene>,
    backends: &[&dyn Contestant],
    samples: u32,
    watch: &Watch<'_>,
) -> Result<Vec<Measure>, Error> {
    let task = group.task;
    let judged = loaded.par_iter().map(|scene| {
        let case = task.case(scene, watch).map_err(Error::from)?;
        if let Some(dispute) = case.dispute() {
            let Group { kind, family, .. } = group;
            return Err(Error::unfit(format!("{}, {kind} {family}, is not judged: {dispute}", task.name())));
        }
        let places = scene.content::<Complexes>().map(|content| exact_places(&scene.scene, content));
        let asked = (&*task.kinds(&scene.scene), task.constructs_vertices());
        let of = |backend: &&dyn Contestant| -> Result<(Outcome, Option<i32>, Errors), Error> {
            let outcome = run(case.as_ref(), *backend, Budget::QUICK, watch).map_err(Error::from)?;
            let errors = errors(scene, *backend, places.as_deref().unwrap_or_default(), watch);
            let bits = bits(*backend, &scene.scene, asked, &outcome.stages);
            watch.done(1)?;
            Ok((outcome, bits, errors))
        };
        backends.iter().map(of).collect::<Result<Vec<_>, Error>>()
    });
    let judged: Vec<Vec<(Outcome, Option<i32>, Errors)>> = judged.collect::<Result<_, Error>>()?;
    let mut seen: Vec<Seen> = backends.iter().map(|_| Seen::default()).collect();
    for of_scene in judged {
        for (seen, (outcome, bits, errors)) in seen.iter_mut().zip(of_scene) {
            seen.add(&outcome, bits);
            seen.errors.merge(errors);
        }
    }
    let taken = match timed {
        None => Vec::new(),
        Some(timed) => taken(timed, backends, samples, watch)?,
    };
    let mut all = Vec::new();
    for (at, (backend, seen)) in backends.iter().zip(&seen).enumerate() {
        let name = backend.name();
        let about = About { task: group.task.name(), kind: group.kind, family: group.family, backend: &name };
        let has_laws = task.declared_checks().iter().any(|check| check.class == Class::Topology);
        all.extend(answers(&about, seen, has_laws));
        all.extend(located(&about, &seen.errors));
        if let Some(taken) = taken.get(at) {
            all.extend(about.median("time", "ns a query", &taken.nanoseconds));
            let points = taken.constructed.filter(|points| *points > 0).map(approximately);
            all.extend(points.map(|points| about.measure("constructed", "points", points, [points; 2], 1)));
            let bytes = taken.bytes.map(approximately);
            all.extend(bytes.map(|bytes| about.measure("memory", "bytes", bytes, [bytes; 2], 1)));
        }
    }
    Ok(all)
}

/// The measures of answers.
///
/// First the scenes asked by their worst class, then the scenes and answers of the answered ones.
fn answers(about: &About<'_>, seen: &Seen, has_laws: bool) -> Vec<Measure> {
    let of_worst = |severity: Severity| seen.worst[severity as usize];
    // An error for valid input is not an answer.
    let not_done = of_worst(Severity::NotDone) + of_worst(Severity::Refused);
    let mut all = vec![about.share("declined", "share of scenes", 1.0, seen.declined, seen.scenes)];
    for (measure, count) in [
        ("not done", not_done),
        ("right", of_worst(Severity::Right)),
        ("undecided", of_worst(Severity::Undecided)),
        ("rounded", of_worst(Severity::Rounded)),
    ] {
        all.push(about.share(measure, "share of scenes", 1.0, count, seen.scenes));
    }
    let answered = seen.scenes - not_done;
    if answered == 0 {
        return all;
    }
    let wrong = of_worst(Severity::Broken) + of_worst(Severity::Accepted);
    all.push(about.share("wrong scenes", "per 1000 scenes", 1000.0, wrong, answered));
    if has_laws {
        all.push(about.share("topology", "per 1000 scenes", 1000.0, seen.broken, answered));
    }
    for (check, &count) in &seen.checks {
        all.push(about.share(&format!("topology: {check}"), "per 1000 scenes", 1000.0, count, answered));
    }
    let judged: u64 =
        Class::ALL.into_iter().filter(|class| class.is_answer()).map(|class| seen.counts.get(class)).sum();
    if judged > 0 {
        let wrong = Class::ALL.into_iter().filter(|class| class.is_wrong_answer());
        let wrong: u64 = wrong.map(|class| seen.counts.get(class)).sum();
        all.push(about.share("wrong answers", "per 10^6 answers", 1e6, wrong, judged));
    }
    use Class::{Inconsistent, MissedZero, Nan, Overreach, SignFlip, Unstable};
    let of_queries = [SignFlip, MissedZero, Overreach, Nan, Inconsistent, Unstable];
    for class in of_queries.into_iter().chain([Class::TieBroken, Class::InBand]) {
        let count = seen.counts.get(class);
        if count > 0 || (judged > 0 && of_queries[..3].contains(&class)) {
            all.push(about.share(class.name(), "per 10^6 answers", 1e6, count, judged));
        }
    }
    let settled: u64 = seen.stages.values().sum();
    for (stage, &count) in &seen.stages {
        all.push(about.share(&format!("stage: {stage}"), "share of queries", 1.0, count, settled));
    }
    // If the bits of only some scenes are known, these are the easy scenes.
    let (bits, known, unknown) = seen.bits;
    if known > 0 && unknown == 0 {
        let bits = f64::from(bits);
        all.push(about.measure("bits", "at most", bits, [bits; 2], known));
    }
    all
}

/// The measures of location errors of contacts.
fn located(about: &About<'_>, errors: &Errors) -> Vec<Measure> {
    let mut all = Vec::new();
    if errors.looked_at == 0 {
        return all;
    }
    all.push(about.share("registered apart", "share of contacts", 1.0, errors.apart, errors.looked_at));
    all.push(about.share("registered alone", "share of contacts", 1.0, errors.alone, errors.looked_at));
    for (name, unit, of_all) in [
        ("location", "scene units", &errors.location),
        ("location", "L", &errors.location_over_l),
        ("missed by", "L", &errors.missed_over_l),
        ("weight", "of one", &errors.weight),
    ] {
        let of = of_all.len() as u64;
        let Some(tail) = tail(of_all) else { continue };
        all.push(about.measure(&format!("{name}: median"), unit, tail.median, [tail.quartile, tail.most], of));
        all.push(about.measure(&format!("{name}: 99 %"), unit, tail.most, [tail.median, tail.max], of));
        all.push(about.measure(&format!("{name}: max"), unit, tail.max, [tail.most, tail.max], of));
    }
    all
}

/// The errors of the contacts of a scene; empty if it is of another task, or the backend declines it.
fn errors(scene: &LoadedScene, backend: &dyn Contestant, places: &[Vec<f64>], watch: &Watch<'_>) -> Errors {
    let mut errors = Errors::default();
    let (Some(content), Some(solver)) = (scene.content::<Complexes>(), backend.solver(scene.task)) else {
        return errors;
    };
    let how = How { purpose: Purpose::Use, watch };
    // Declined scenes were counted before.
    let _ = solver.solve(&scene.scene, scene.content.as_ref(), &Counts::new(), &how, &mut |_, answer| {
        if let Some(found) = answer.downcast_ref() {
            errors.add(&scene.scene, content, found, places);
        }
        Ok(())
    });
    errors
}
