//! Tests that judges of other programs' answers pass right answers, however they are rounded.
//!
//! The answers are those of this project's backends, in the form of a program's answer: constructed vertices at their
//! nearest doubles, or at doubles beside these. Planted wrong answers are in `selftest`.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::AtomicBool;

use predicament_corpus::{Level, Library, LoadedScene};
use predicament_formats::Cache;
use predicament_predicates::{Counts, Scene};
use predicament_tasks::replies::{Array, Arrays, Reply};
use predicament_tasks::{Asked, Budget, Class, Contestant, How, Outcome, Purpose, Watch};

/// The coordinates of an answer that are not coordinates of the scene: its rounded vertices.
fn rounded(scene: &Scene, arrays: &Arrays, change: impl Fn(usize, f64) -> f64) -> Arrays {
    let given: BTreeSet<u64> = scene.coordinates().iter().map(|x| x.to_bits()).collect();
    let mut changed = Arrays::default();
    for (name, array) in arrays.iter() {
        let array = match array {
            Array::Numbers(numbers) => {
                // Equal numbers stay equal: a vertex that several rings or triangles share is one vertex.
                let moved = |&x: &f64| {
                    let place = usize::try_from(x.to_bits() % 3).unwrap();
                    if given.contains(&x.to_bits()) { x } else { change(place, x) }
                };
                Array::Numbers(numbers.iter().map(moved).collect())
            }
            other => other.clone(),
        };
        changed.add(name, array);
    }
    changed
}

/// A function that gives the double that a library computes instead of another, by a number of three.
type Round = fn(usize, f64) -> f64;

/// Neighbours of a double that a library may compute instead of it.
fn roundings() -> [(&'static str, Round); 4] {
    [
        ("to nearest", |_, x| x),
        ("up", |_, x| x.next_up()),
        ("toward zero", |_, x| if x > 0.0 { x.next_down() } else { x.next_up() }),
        ("up, down or not at all", |place, x| [x.next_up(), x.next_down(), x][place]),
    ]
}

fn judged(loaded: &LoadedScene, backend: &dyn Contestant, round: Round) -> Option<Outcome> {
    let task = predicament_bundle::task(loaded.task).unwrap();
    task.question(&loaded.scene, loaded.content.as_ref()).ok()?;
    let (never, quiet) = (AtomicBool::new(false), |_: u64| {});
    let watch = Watch::new(&never, None, &quiet);
    let case = task.case(loaded, &watch).unwrap();
    let mut outcome = Outcome { queries: loaded.count() as u64, ..Outcome::default() };
    let how = How { purpose: Purpose::Judge, watch: &watch };
    let solver = backend.solver(task.name()).unwrap();
    let solved = solver.solve(&loaded.scene, loaded.content.as_ref(), &Counts::new(), &how, &mut |session, answer| {
        let arrays = task.as_reply(&loaded.scene, loaded.content.as_ref(), answer).unwrap();
        let arrays = rounded(&loaded.scene, &arrays, round);
        let asked = Asked { backend, session, budget: Budget::QUICK, watch: &watch };
        case.judge(&asked, &Reply { arrays, ..Reply::default() }, &mut outcome)
    });
    solved.ok().map(|()| outcome)
}

#[test]
fn right_answers_pass_however_they_are_rounded() {
    let library = Library::embedded(predicament_bundle::vocabulary()).unwrap();
    let cache = Cache::new("/nonexistent/predicament-cache");
    let backends = ["exact", "sos", "sos:per-mesh"].map(|name| predicament_bundle::backend(name).unwrap());
    let [exact, sos, per_mesh] = &backends;
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    let mut seen: BTreeMap<&str, usize> = BTreeMap::new();
    let step = predicament_effort::some_or_all(6, 1);
    for suite in library.suites().unwrap() {
        for scene in suite.scenes.iter().filter(|scene| !scene.needs_fetch()) {
            let task = predicament_bundle::task(scene.task).unwrap();
            if task.parts_of_replies().is_none() {
                continue;
            }
            // An even part of each task's scenes.
            let place = seen.entry(task.name()).or_default();
            *place += 1;
            if !(*place - 1).is_multiple_of(step) {
                continue;
            }
            let loaded = scene.load(Level::Quick, &cache).unwrap();
            let backend = match scene.task {
                // `exact` declines meshes that touch, and counts walls between cubes that touch wrongly.
                "mesh-intersect" => per_mesh,
                "cube-union" => sos,
                _ => exact,
            };
            for (name, round) in roundings() {
                let Some(outcome) = judged(&loaded, backend.as_ref(), round) else { continue };
                let [suite, scene] = [&loaded.suite, &loaded.name];
                let findings: Vec<String> =
                    outcome.findings.iter().map(|finding| format!("{}: {}", finding.check, finding.got)).collect();
                // Polygons that are no polygons are findings for every backend.
                let is_invalid = outcome.findings.iter().all(|finding| finding.check == "loops do not cross");
                assert!(is_invalid, "{suite}/{scene}, rounded {name}: {findings:?}");
                assert!(outcome.counts.get(Class::Agree) > 0 || !findings.is_empty(), "{suite}/{scene}: not judged");
                *counts.entry(task.name()).or_default() += 1;
            }
        }
    }
    let open = predicament_bundle::tasks().iter().filter(|task| task.parts_of_replies().is_some());
    for task in open {
        let count = counts.get(task.name()).copied().unwrap_or(0);
        assert!(count >= 4, "{}: {count} answers were judged", task.name());
    }
}
