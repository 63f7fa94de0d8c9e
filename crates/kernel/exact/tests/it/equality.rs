//! Determinants that equal the bound of the static filter, in sessions and batches.
//!
//! One difference is t and all others are 0, 1 or −1, so the determinant is t or 2t in floating point as well as
//! exactly. With the scene's bound for t, or half of it, the filter must answer; with the next double below it must
//! not.

use crate::common;
use predicament_arithmetic::bound::{static_incircle, static_insphere, static_orient2d, static_orient3d};
use predicament_exact::{Exact, stage};
use predicament_predicates::{
    Backend, Counts, Dimension, Plane, PredicateKind, QuerySet, Question, Scene, Sign, Vertex,
};

/// Queries these points of the scene, alone and seventy times in a batch.
///
/// All answers must be the sign, and the stage must settle the batch (alone, a turn runs its own filter).
fn settled(question: Question, scene: &Scene, args: &[Vertex], sign: Sign, stage: usize) {
    let counts = Counts::new();
    let session = Exact.prepare(scene, &counts).expect("any scene");
    let queries = QuerySet::new(question, args.repeat(70));
    let mut answers = vec![Sign::Zero; queries.len()];
    queries.ask_batch(&session, 0..queries.len(), &mut answers);
    let by_stage: Vec<u64> = (0..stage::NAMES.len()).map(|stage| counts.get(question.kind(), stage)).collect();
    answers.push(question.ask(&session, args));
    assert!(answers.iter().all(|&answer| answer == sign), "{question:?} {scene:?}");
    let alone = counts.get(question.kind(), stage) - by_stage[stage];
    assert!(alone == 1 || question.kind() == PredicateKind::Orient2d, "alone, not by {}", stage::NAMES[stage]);
    assert_eq!(by_stage[stage], 70, "{question:?} {scene:?}: {by_stage:?}, not all by {}", stage::NAMES[stage]);
}

/// Checks the stage at the bound and just below it, with either sign.
fn at_the_bound(question: Question, bound: f64, points: impl Fn(f64) -> Vec<Vec<f64>>, truth: impl Fn(f64) -> Sign) {
    // A session's bound covers underflow.
    let bound = bound * (1.0 + 4.0 * f64::EPSILON);
    for (t, stage) in [(bound, stage::STATIC), (bound.next_down(), stage::SEMI_STATIC)] {
        let points = points(t);
        let dimension = if points[0].len() == 2 { Dimension::Two } else { Dimension::Three };
        let scene = Scene::new(dimension, points.concat()).expect("finite");
        let mut args: Vec<Vertex> = (0..question.kind().arity()).map(Vertex::input).collect();
        settled(question, &scene, &args, truth(t), stage);
        args.swap(0, 1);
        settled(question, &scene, &args, -truth(t), stage);
    }
}

/// The first N points, in the judge's form.
fn first<const D: usize, const N: usize>(points: &[Vec<f64>]) -> [[f64; D]; N] {
    std::array::from_fn(|i| std::array::from_fn(|j| points[i][j]))
}

#[test]
fn orient2d_at_the_bound() {
    let points = |t| vec![vec![t, 0.0], vec![0.0, 1.0], vec![0.0, 0.0], vec![1.0, 1.0]];
    at_the_bound(Question::Orient2d(Plane::Xy), static_orient2d([1.0, 1.0]), points, |t| {
        common::orient2d(&first(&points(t)))
    });
}

#[test]
fn orient3d_at_the_bound() {
    let points =
        |t| vec![vec![t, 0.0, 0.0], vec![0.0, 1.0, 0.0], vec![0.0, 0.0, 1.0], vec![0.0; 3], vec![1.0, 1.0, 1.0]];
    at_the_bound(Question::Orient3d, static_orient3d([1.0; 3]), points, |t| common::orient3d(&first(&points(t))));
}

#[test]
fn incircle_at_the_bound() {
    let points = |t: f64| vec![vec![t / 2.0, 0.0], vec![0.0, 1.0], vec![0.0, -1.0], vec![0.0; 2], vec![1.0, 1.0]];
    at_the_bound(Question::Incircle, static_incircle([1.0, 2.0]), points, |t| common::incircle(&first(&points(t))));
}

#[test]
fn insphere_at_the_bound() {
    let points = |t: f64| {
        vec![
            vec![t / 2.0, 0.0, 0.0],
            vec![0.0, 1.0, 0.0],
            vec![0.0, 0.0, 1.0],
            vec![0.0, -1.0, 0.0],
            vec![0.0; 3],
            vec![1.0, 1.0, 1.0],
        ]
    };
    at_the_bound(Question::Insphere, static_insphere([1.0, 2.0, 1.0]), points, |t| {
        common::insphere(&first(&points(t)))
    });
}
