//! The judge of crossings: it accepts right answers, and reports the errors of others.

use std::sync::Arc;

use predicament_corpus::LoadedScene;
use predicament_crossings::algorithm::crossings;
use predicament_crossings::task::{Crossed, Crossings, Segments};
use predicament_judge::Judged;
use predicament_predicates::{Predicates, Scene, Vertex};
use predicament_tasks::{Asked, Budget, Class, Outcome};

use crate::common::{checks, load, suite, with_case};

/// The outcome for a possible answer of a backend.
fn judged(loaded: &LoadedScene, backend: &str, answer: &Crossed) -> Outcome {
    let contestant = predicament_bundle::backend(backend).unwrap();
    with_case(loaded, |case, watch| {
        let mut outcome = Outcome::default();
        let ask = &mut |session: &mut dyn Predicates| {
            let asked = Asked { backend: contestant.as_ref(), session, budget: Budget::QUICK, watch };
            case.judge(&asked, answer, &mut outcome).unwrap();
        };
        contestant.with_session(&loaded.scene, ask).unwrap();
        outcome
    })
}

fn honest(loaded: &LoadedScene, backend: &str) -> Crossed {
    let content: &Segments = loaded.content().unwrap();
    predicament_bundle::backend(backend).unwrap().answer(&Crossings, &loaded.scene, content).unwrap()
}

/// A way to corrupt the crossings of one segment; returns false if it has too few crossings.
type Spoil = fn(&mut Vec<Vec<u32>>) -> bool;

const SPOILT: [(&str, Spoil, Class, &str); 4] = [
    ("a crossing is lost", |along| along.pop().is_some(), Class::SignFlip, "crossings"),
    (
        "two points change places",
        |along| {
            along.len() > 1 && along[0] != along[1] && {
                along.swap(0, 1);
                true
            }
        },
        Class::SignFlip,
        "order",
    ),
    (
        "two points are taken for one",
        |along| {
            along.len() > 1 && {
                let second = along.remove(1);
                along[0].extend(second);
                along[0].sort_unstable();
                true
            }
        },
        Class::Overreach,
        "order",
    ),
    (
        "one point is taken for two",
        |along| {
            let Some(at) = along.iter().position(|group| group.len() > 1) else { return false };
            let last = along[at].pop().unwrap();
            along.insert(at + 1, vec![last]);
            true
        },
        Class::MissedZero,
        "order",
    ),
];

#[test]
fn every_way_to_spoil_an_answer_has_its_class() {
    for (what, spoil, class, check) in SPOILT {
        let mut spoilt = 0;
        for loaded in suite("crossings") {
            let mut answer = honest(&loaded, "exact");
            assert_eq!(checks(&judged(&loaded, "exact", &answer)), [], "{}", loaded.name);
            if !answer.0.iter_mut().any(spoil) {
                continue;
            }
            spoilt += 1;
            let outcome = judged(&loaded, "exact", &answer);
            assert_eq!(outcome.counts.findings(), 1, "{what} in {}", loaded.name);
            assert_eq!(checks(&outcome), [(class, check)], "{what} in {}", loaded.name);
        }
        assert!(spoilt > 0, "{what} nowhere");
    }
}

/// Without a perturbation, a segment that ends on another does not cross it.
#[test]
fn a_touch_taken_for_a_crossing_is_a_missed_zero() {
    let loaded = load("touching");
    let mut answer = honest(&loaded, "exact");
    let has = |along: &Vec<Vec<u32>>, other| along.iter().flatten().any(|&found| found == other);
    assert!(!has(&answer.0[0], 1) && !has(&answer.0[1], 0), "{answer:?}");
    answer.0[0].insert(0, vec![1]);
    answer.0[1].push(vec![0]);
    let outcome = judged(&loaded, "exact", &answer);
    assert_eq!((outcome.counts.findings(), checks(&outcome)), (2, vec![(Class::MissedZero, "crossings")]));
}

/// A backend that breaks ties has one right answer, that of the perturbed scene.
#[test]
fn a_perturbed_scene_has_one_answer() {
    for loaded in suite("crossings") {
        let mut answer = honest(&loaded, "sos");
        assert_eq!(checks(&judged(&loaded, "sos", &answer)), [], "{}", loaded.name);
        let Some(along) = answer.0.iter_mut().find(|along| along.len() > 1) else { continue };
        along.reverse();
        assert_eq!(
            checks(&judged(&loaded, "sos", &answer)),
            [(Class::SignFlip, "perturbed crossings")],
            "{}",
            loaded.name
        );
    }
}

/// Two computations of the truth about a perturbed scene: the judge's, which tests every pair, and the driver's on a
/// session that breaks ties by polynomials.
#[test]
fn the_truth_about_a_perturbed_scene_is_computed_twice() {
    let (mut broken, template) = (0, load("touching"));
    for seed in 0..40_i32 {
        let at = |i: i32| f64::from((seed * 7 + i * i * 3 + i * seed) % 5);
        let points: Vec<[f64; 2]> = (0..12).map(|i| [at(2 * i), at(2 * i + 1)]).collect();
        let scene = Scene::from_points2(&points).unwrap();
        let segments: Vec<[Vertex; 2]> = (0..6).map(|i| [2 * i, 2 * i + 1].map(Vertex::input)).collect();
        let contestant = predicament_bundle::backend("sos").unwrap();
        let ties = contestant.tie_judge().unwrap();
        let driver = crossings(&mut Judged::perturbed(&scene, ties), &segments).unwrap();
        let exact = crossings(&mut Judged::exact(&scene), &segments).unwrap();
        broken += usize::from(driver != exact);
        let loaded = LoadedScene { scene, content: Arc::new(Segments(segments)), ..template.clone() };
        assert_eq!(checks(&judged(&loaded, "sos", &Crossed(driver))), [], "{seed}");
    }
    assert!(broken > 10, "ties matter in {broken} scenes of 40");
}
