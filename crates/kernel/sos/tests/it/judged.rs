//! The term lists against explicit infinitesimals.

use crate::common::{Random, ask_antisymmetric, first, grid_scene, questions, scene, words};
use predicament_effort::{scaled, whole};
use predicament_exact::Exact;
use predicament_predicates::{Backend, Off, Predicates, Question, Scene, Sign, Vertex};
use predicament_sos::{Scheme, Sos, infinitesimal::judge};
use proptest::prelude::*;

/// Checks all properties of one query.
fn check(scene: &Scene, question: Question, args: &[Vertex]) {
    let exact = question.ask(&Exact.prepare(scene, Off).unwrap(), args);
    for scheme in Scheme::ALL {
        let sos = Sos { scheme };
        let answer = ask_antisymmetric(&sos.prepare(scene, Off).unwrap(), question, args);
        let context = || format!("{scheme} {question:?} of {args:?} in {scene:?}");
        assert!(!answer.is_zero(), "zero: {}", context());
        assert!(exact.is_zero() || answer == exact, "not exact: {}", context());
        assert_eq!(answer, judge(scheme, scene, question, args), "{}", context());
    }
}

/// Checks every question with as many vertices as the scene has points.
fn check_scene(dimension: usize, side: usize, numbers: &[usize]) {
    let scene = grid_scene(dimension, side, numbers);
    for question in questions(dimension).into_iter().filter(|q| q.kind().arity() == numbers.len()) {
        check(&scene, question, &first(numbers.len()));
    }
}

/// All assignments of grid points to vertices, so all index orders and all coincidences.
#[test]
fn exhaustively_on_the_3_by_3_grid() {
    for arity in 2..=4 {
        words(9, arity).for_each(|numbers| check_scene(2, 3, &numbers));
    }
}

#[test]
fn exhaustively_on_the_cube() {
    for arity in 2..=4 {
        words(8, arity).for_each(|numbers| check_scene(3, 2, &numbers));
    }
}

/// All 32768 assignments at full effort, else some of them; 27 has no common factor with 8.
#[test]
fn spheres_of_the_cube() {
    let step = if whole() { 1 } else { 27 };
    words(8, 5).step_by(step).for_each(|numbers| check_scene(3, 2, &numbers));
}

#[test]
fn at_random_on_the_3_by_3_by_3_grid() {
    let mut random = Random(1);
    for _ in 0..scaled(2000) {
        for arity in 3..=5 {
            check_scene(3, 3, &random.numbers(27, arity));
        }
    }
}

/// Few different points, so most queries have coincident ones.
#[test]
fn at_random_on_coincident_points() {
    let mut random = Random(2);
    for _ in 0..scaled(1000) {
        for (dimension, arity) in [(2, 3), (2, 4), (3, 4), (3, 5)] {
            let points = random.numbers(3_usize.pow(u32::try_from(dimension).unwrap()), 2);
            let numbers: Vec<usize> = (0..arity).map(|_| points[random.below(2)]).collect();
            check_scene(dimension, 3, &numbers);
        }
    }
}

#[test]
fn repeated_vertices_are_zero() {
    let scenes = [grid_scene(2, 3, &[0, 4, 8, 2, 5]), grid_scene(3, 3, &[0, 13, 26, 5, 7])];
    for scheme in Scheme::ALL {
        for scene in &scenes {
            let sos = Sos { scheme };
            let session = sos.prepare(scene, Off).unwrap();
            for question in questions(scene.dimension().count()) {
                let mut args = first(question.kind().arity());
                *args.last_mut().unwrap() = args[0];
                assert_eq!(question.ask(&session, &args), Sign::Zero);
                assert_eq!(judge(scheme, scene, question, &args), Sign::Zero);
            }
        }
    }
}

/// Two coincident vertices, so that everything is a tie, and minors of the others about which no filter is certain.
///
/// Their points are an ulp away from a line, in every projection.
#[test]
fn minors_that_need_more_than_a_filter() {
    const PLACES: [f64; 3] = [0.5, 12.0, 24.0];
    let mut random = Random(7);
    for _ in 0..scaled(300) {
        for (dimension, arity) in [(2, 4), (3, 4), (3, 5)] {
            let mut points: Vec<Vec<f64>> = (0..arity - 1)
                .map(|at| {
                    let mut near = |x: f64| (0..random.below(4)).fold(x, |x, _| x.next_up());
                    (0..dimension).map(|_| near(PLACES[at % 3])).collect()
                })
                .collect();
            let (from, to) = (random.below(points.len()), random.below(arity));
            let twin = points[from].clone();
            points.insert(to, twin);
            let scene = scene(dimension, points.concat()).unwrap();
            for question in questions(dimension).into_iter().filter(|question| question.kind().arity() == arity) {
                check(&scene, question, &first(arity));
            }
        }
    }
}

/// All signs are those of homogeneous polynomials, so a power of two changes none.
///
/// At the ends of the exponent range everything but integers would fail.
#[test]
fn scaling_changes_nothing() {
    let mut random = Random(3);
    for _ in 0..100 {
        for dimension in [2, 3] {
            let unscaled = grid_scene(dimension, 3, &random.numbers(9, 5));
            for factor in [f64::from_bits(1), 2_f64.powi(-600), 2_f64.powi(1022)] {
                let coordinates = unscaled.coordinates().iter().map(|x| x * factor).collect();
                let scaled = scene(dimension, coordinates).unwrap();
                for scheme in Scheme::ALL {
                    let sos = Sos { scheme };
                    let [small, large] = [&unscaled, &scaled].map(|scene| sos.prepare(scene, Off).unwrap());
                    for question in questions(dimension) {
                        let args = first(question.kind().arity());
                        assert_eq!(question.ask(&small, &args), question.ask(&large, &args));
                    }
                }
            }
        }
    }
}

/// The order of the indices counts, not their values.
#[test]
fn gaps_between_indices_change_nothing() {
    let mut random = Random(4);
    for _ in 0..200 {
        let numbers = random.numbers(27, 5);
        let dense = grid_scene(3, 3, &numbers);
        let sparse = grid_scene(3, 3, &numbers.iter().flat_map(|&n| [n; 3]).collect::<Vec<_>>());
        let apart: Vec<Vertex> = (0..5).map(|i| Vertex::input(3 * i + random.below(3))).collect();
        for scheme in Scheme::ALL {
            let sos = Sos { scheme };
            let [dense, sparse] = [&dense, &sparse].map(|scene| sos.prepare(scene, Off).unwrap());
            for question in questions(3) {
                let arity = question.kind().arity();
                let answer = question.ask(&dense, &first(arity));
                assert_eq!(answer, question.ask(&sparse, &apart[..arity]));
                assert_eq!(answer, judge(scheme, sparse.scene(), question, &apart[..arity]));
            }
        }
    }
}

proptest! {
    #[test]
    fn small_integers_in_the_plane(coordinates in prop::collection::vec(-4_i8..=4, 8), question in 0_usize..4) {
        let scene = scene(2, coordinates.into_iter().map(f64::from).collect()).unwrap();
        let question = questions(2)[question];
        check(&scene, question, &first(question.kind().arity()));
    }

    #[test]
    fn small_integers_in_space(coordinates in prop::collection::vec(-2_i8..=2, 15), question in 0_usize..8) {
        let scene = scene(3, coordinates.into_iter().map(f64::from).collect()).unwrap();
        let question = questions(3)[question];
        check(&scene, question, &first(question.kind().arity()));
    }
}
