//! Tests that judges of other programs' answers pass right answers, however they are rounded.
//!
//! The answers are those of this project's backends, in the form of a program's answer: constructed vertices at their
//! nearest doubles, or at doubles beside these. Planted wrong answers are in `selftest`.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::AtomicBool;

use predicament_corpus::{Level, Library, LoadedScene, Suite};
use predicament_formats::{Cache, Manifest};
use predicament_predicates::{Counts, Scene};
use predicament_tasks::replies::{Array, Arrays, Reply};
use predicament_tasks::{AnyCase, Asked, Budget, Class, Contestant, Dispute, How, Outcome, Purpose, Watch};

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

/// The checks that find a fault in an answer to a scene of a suite.
fn checks(suite: &str, arrays: &Arrays) -> Vec<String> {
    let text = format!("title = \"Mine\"\n[[scene]]\nname = \"mine\"\n{suite}");
    let suite = Suite::parse(predicament_bundle::vocabulary(), "s.toml", &text, None, &Manifest::default()).unwrap();
    let loaded = suite.scenes[0].load(Level::Quick, &Cache::new("/nonexistent/predicament-cache")).unwrap();
    let (never, quiet) = (AtomicBool::new(false), |_: u64| {});
    let watch = Watch::new(&never, None, &quiet);
    let case = predicament_bundle::task(loaded.task).unwrap().case(&loaded, &watch).unwrap();
    let exact = predicament_bundle::backend("exact").unwrap();
    let mut outcome = Outcome { queries: loaded.count() as u64, ..Outcome::default() };
    let reply = Reply { arrays: arrays.clone(), ..Reply::default() };
    exact
        .with_session(&loaded.scene, &mut |session| {
            let asked = Asked { backend: exact.as_ref(), session, budget: Budget::QUICK, watch: &watch };
            case.judge(&asked, &reply, &mut outcome).unwrap();
        })
        .unwrap();
    outcome.findings.into_iter().map(|finding| finding.check).collect()
}

/// A segment from 0 to 4 on the x axis; one that crosses it at 1, one that begins on it at 2, one on it from 2 to 3,
/// and one that crosses it at 3.
#[test]
fn segments_that_touch_may_be_listed_by_both_in_any_order_at_their_place() {
    let scene = "task = \"crossings\"\n\
        points = [[0, 0], [4, 0], [1, -1], [1, 1], [2, 0], [2, 1], [2, 0], [3, 0], [3, -1], [3, 1]]\n\
        segments = [[0, 1], [2, 3], [4, 5], [6, 7], [8, 9]]\n";
    let told = |first: &[u32], by_both: bool| {
        let other = |at: u32| if by_both && first.contains(&at) || at == 1 || at == 4 { vec![0] } else { vec![] };
        let lists: Vec<Vec<u32>> = std::iter::once(first.to_vec()).chain((1..5).map(other)).collect();
        let mut arrays = Arrays::default();
        arrays.add_lists("crossings", &lists);
        checks(scene, &arrays)
    };
    for right in [&[1, 4][..], &[1, 2, 4], &[1, 2, 3, 4], &[1, 3, 2, 4], &[1, 4, 3], &[1, 2, 4, 3]] {
        assert_eq!(told(right, true), [""; 0], "{right:?}");
    }
    for wrong in [&[4, 1][..], &[2, 1, 4], &[1, 4, 2], &[3, 1, 4]] {
        assert_eq!(told(wrong, true), ["order of crossings"], "{wrong:?}");
    }
    assert_eq!(told(&[1], true), ["lost crossing", "strange crossing"]);
    assert_eq!(told(&[1, 2, 4], false), ["strange crossing"], "by one alone");
    assert_eq!(told(&[0, 1, 4], true), ["strange crossing"], "itself");
}

#[test]
fn at_an_end_both_cells_are_right_and_outside_only_at_the_ends_of_the_row() {
    // Ends at 0, 1 and 2; probes inside of the second cell, between the cells, at the first end, and outside.
    let scene = "task = \"interval\"\naxis = \"x\"\n\
        points = [[0, 0], [1, 0], [2, 0], [1.5, 0], [1, 1], [0, 1], [9, 0]]\ncells = [[0, 1], [1, 2]]\n";
    let [outside, at_end] = [u32::MAX, u32::MAX - 1];
    let right: [&[u32]; 4] = [&[1], &[0, 1, at_end], &[0, outside, at_end], &[outside]];
    for (probe, right_here) in right.iter().enumerate() {
        for label in [0, 1, 2, outside, at_end] {
            let mut labels: Vec<u32> = right.iter().map(|labels| labels[0]).collect();
            labels[probe] = label;
            let mut arrays = Arrays::default();
            arrays.add("labels", Array::Ids(labels));
            let is_right = checks(scene, &arrays).is_empty();
            assert_eq!(is_right, right_here.contains(&label), "probe {probe}, label {label}");
        }
    }
}

#[test]
fn right_answers_pass_however_they_are_rounded() {
    let library = Library::embedded(predicament_bundle::vocabulary()).unwrap();
    let cache = Cache::new("/nonexistent/predicament-cache");
    let exact = predicament_bundle::backend("exact").unwrap();
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    let mut seen: BTreeMap<&str, usize> = BTreeMap::new();
    let step = predicament_effort::some_or_all(24, 1);
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
            for (name, round) in roundings() {
                let Some(outcome) = judged(&loaded, exact.as_ref(), round) else { continue };
                let [suite, scene] = [&loaded.suite, &loaded.name];
                let findings: Vec<String> =
                    outcome.findings.iter().map(|finding| format!("{}: {}", finding.check, finding.got)).collect();
                assert!(findings.is_empty(), "{suite}/{scene}, rounded {name}: {findings:?}");
                assert!(outcome.counts.get(Class::Agree) > 0, "{suite}/{scene}: not judged");
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

/// The scenes of a text, or of the suite of invalid input.
fn invalid_input(text: Option<&str>) -> Vec<LoadedScene> {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../engines/invalid.toml");
    let own = std::fs::read_to_string(file).unwrap();
    let (vocabulary, text) = (predicament_bundle::vocabulary(), text.unwrap_or(&own));
    let suite = Suite::parse(vocabulary, "invalid.toml", text, None, &Manifest::default()).unwrap();
    let load = |scene: &predicament_corpus::SceneDef| scene.load(Level::Quick, &Cache::new("/nonexistent")).unwrap();
    suite.scenes.iter().map(load).collect()
}

/// Calls a function with the case of a scene.
fn with_case<R>(loaded: &LoadedScene, then: impl FnOnce(&dyn AnyCase, &Watch<'_>) -> R) -> R {
    let (never, quiet) = (AtomicBool::new(false), |_: u64| {});
    let watch = Watch::new(&never, None, &quiet);
    let case = predicament_bundle::task(loaded.task).unwrap().case(loaded, &watch).unwrap();
    then(case.as_ref(), &watch)
}

#[test]
fn the_judge_confirms_each_mark_of_invalid_input_and_programs_get_it() {
    let scenes = invalid_input(None);
    assert!(scenes.iter().any(|loaded| !loaded.is_invalid), "valid neighbours");
    for loaded in &scenes {
        let task = predicament_bundle::task(loaded.task).unwrap();
        let name = &loaded.name;
        assert!(task.question(&loaded.scene, loaded.content.as_ref()).is_ok(), "{name} is put to programs");
        with_case(loaded, |case, watch| {
            assert_eq!((case.invalid().is_some(), case.dispute()), (loaded.is_invalid, None), "{name}");
            // A backend of this project is not asked.
            let exact = predicament_bundle::backend("exact").unwrap();
            let outcome = predicament_tasks::run(case, exact.as_ref(), Budget::QUICK, watch).unwrap();
            let declined = outcome.findings.iter().map(|finding| (finding.class, finding.check.as_str()));
            let expected = if loaded.is_invalid { vec![(Class::Declined, "prepare")] } else { vec![] };
            assert_eq!(declined.collect::<Vec<_>>(), expected, "{name}");
        });
        // The mark is in the written form, so that a smaller scene keeps it.
        let text = loaded.spelled().unwrap().suite("again", predicament_corpus::Heading::default());
        let again = invalid_input(Some(&text.replace("name = \"\"", "name = \"again\"")));
        assert_eq!((again[0].is_invalid, &again[0].id), (loaded.is_invalid, &loaded.id), "{name}: {text}");
    }
}

#[test]
fn a_mark_on_valid_input_is_refused() {
    let square = "title = \"Mine\"\n[[scene]]\nname = \"square\"\ntask = \"triangulate\"\ninvalid = true\n\
                  points = [[0, 0], [4, 0], [4, 4], [0, 4]]\n";
    let scenes = invalid_input(Some(square));
    with_case(&scenes[0], |case, _| assert_eq!(case.dispute(), Some(Dispute::Valid)));
}
