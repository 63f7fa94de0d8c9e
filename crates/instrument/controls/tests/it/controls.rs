//! The values of each control, and inputs for which it must be wrong.

use predicament_controls::{BadEpsilon, Epsilon, Naive, Pivot, Shewchuk, constructed};
use predicament_predicates::{
    Axis, Backend, Construction, Counts, Off, Plane, PredicateKind, Predicates, Question, Scene, Sign, Vertex,
    ZeroMeaning,
};
use proptest::prelude::*;

const FIRST: Naive = Naive { pivot: Pivot::First };
const LAST: Naive = Naive { pivot: Pivot::Last };
const TURN: Question = Question::Orient2d(Plane::Xy);

fn v(index: usize) -> Vertex {
    Vertex::input(index)
}

/// The sign and the estimate for the first vertices of a scene.
fn ask(backend: &impl Backend, question: Question, scene: &Scene) -> (Sign, f64) {
    let session = backend.prepare(scene, Off).expect("controls take every scene");
    session.supports(question.kind()).expect("a scene of the right dimension");
    let args: Vec<Vertex> = (0..question.kind().arity()).map(v).collect();
    (question.ask(&session, &args), session.estimate(question, &args).expect("controls compute determinants"))
}

fn ask2(backend: &impl Backend, question: Question, points: &[[f64; 2]]) -> (Sign, f64) {
    ask(backend, question, &Scene::from_points2(points).unwrap())
}

fn ask3(backend: &impl Backend, question: Question, points: &[[f64; 3]]) -> (Sign, f64) {
    ask(backend, question, &Scene::from_points3(points).unwrap())
}

/// Points whose differences, products and sums are small integers: every control is correct, and the points distinguish
/// all sign conventions.
#[test]
fn all_agree_on_small_integers() {
    let turn = [[0.0, 0.0], [2.0, 1.0], [1.0, 3.0]];
    let circle = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 1.0]];
    let below = [[0.0, 0.0, 0.0], [3.0, 0.0, 1.0], [0.0, 2.0, 1.0], [1.0, 1.0, -4.0]];
    let sphere = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, -4.0], [1.0, 1.0, -1.0]];
    // By hand: 2·3 − 1·1; |1|² rows (-1,-1,2), (3,-1,10), (-1,3,10); and so on.
    macro_rules! check {
        ($($backend:expr),*) => {$(
            assert_eq!(ask2(&$backend, TURN, &turn), (Sign::Positive, 5.0));
            assert_eq!(ask2(&$backend, Question::Incircle, &circle), (Sign::Positive, 96.0));
            assert_eq!(ask3(&$backend, Question::Orient3d, &below), (Sign::Positive, 29.0));
            assert_eq!(ask3(&$backend, Question::Insphere, &sphere), (Sign::Positive, 576.0));
            assert_eq!(ask2(&$backend, Question::Compare(Axis::Y), &turn), (Sign::Negative, -1.0));
        )*};
    }
    check!(LAST, FIRST, Epsilon::default(), Shewchuk);
}

/// A linear algebra library divides internally: the signs are equal, and the values are equal up to rounding.
#[test]
fn homogeneous_matrices_have_the_same_signs() {
    let homogeneous = Naive { pivot: Pivot::Homogeneous };
    assert_eq!(homogeneous.name(), "naive:nalgebra");
    let turn = [[0.0, 0.0], [2.0, 1.0], [1.0, 3.0]];
    let circle = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 1.0]];
    let below = [[0.0, 0.0, 0.0], [3.0, 0.0, 1.0], [0.0, 2.0, 1.0], [1.0, 1.0, -4.0]];
    let sphere = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, -4.0], [1.0, 1.0, -1.0]];
    for ((sign, value), wanted) in [
        (ask2(&homogeneous, TURN, &turn), 5.0),
        (ask2(&homogeneous, Question::Incircle, &circle), 96.0),
        (ask3(&homogeneous, Question::Orient3d, &below), 29.0),
        (ask3(&homogeneous, Question::Insphere, &sphere), 576.0),
    ] {
        assert_eq!(sign, Sign::Positive);
        assert!((value - wanted).abs() < 1e-9, "{value}");
    }
    // Without a subtraction, rounding hides the turn of a small triangle far from the origin.
    let far = turn.map(|p: [f64; 2]| p.map(|x| x + 2.0_f64.powi(40)));
    assert_eq!(ask2(&LAST, TURN, &far), (Sign::Positive, 5.0));
    let (_, value) = ask2(&homogeneous, TURN, &far);
    assert_ne!(value, 5.0);
}

proptest! {
    /// Integers small enough for plain floating point to be exact, in every predicate and projection: the signs of both
    /// pivots equal Shewchuk's.
    #[test]
    fn pivots_are_equal_where_nothing_rounds(
        flat in proptest::collection::vec(-40i8..=40, 8),
        solid in proptest::collection::vec(-40i8..=40, 15),
    ) {
        let scene = |dimension, from: &[i8]| Scene::new(dimension, from.iter().copied().map(f64::from).collect()).unwrap();
        let flat = scene(predicament_predicates::Dimension::Two, &flat);
        let solid = scene(predicament_predicates::Dimension::Three, &solid);
        for (scene, question) in [
            (&flat, Question::Compare(Axis::X)),
            (&flat, TURN),
            (&flat, Question::Incircle),
            (&solid, Question::Compare(Axis::Z)),
            (&solid, Question::Orient2d(Plane::Yz)),
            (&solid, Question::Orient2d(Plane::Zx)),
            (&solid, Question::Orient3d),
            (&solid, Question::Insphere),
        ] {
            let truth = ask(&Shewchuk, question, scene);
            prop_assert_eq!(ask(&LAST, question, scene), truth);
            prop_assert_eq!(ask(&FIRST, question, scene), truth);
            prop_assert_eq!(ask(&Epsilon::default(), question, scene), truth);
        }
    }
}

/// Kettner, Mehlhorn, Pion, Schirra and Yap 2008, figure 2 (a): the pixels
/// around (0.5, 0.5) against the line through (12, 12) and (24, 24).
#[test]
fn kettners_first_picture_depends_on_the_pivot() {
    let pixel = 2f64.powi(-53);
    let [mut first_wrong, mut last_wrong, mut differ] = [0; 3];
    for i in 0..256 {
        for j in 0..256 {
            let p = [0.5 + f64::from(i) * pixel, 0.5 + f64::from(j) * pixel];
            // Left of the rising diagonal, y > x; pixels below 1 are 2^-53 apart.
            let truth = Sign::from(j.cmp(&i));
            let points = [p, [12.0, 12.0], [24.0, 24.0]];
            let [first, last] = [FIRST, LAST].map(|backend| ask2(&backend, TURN, &points).0);
            assert_eq!(ask2(&Shewchuk, TURN, &points).0, truth, "pixel {i}, {j}");
            first_wrong += u32::from(first != truth);
            last_wrong += u32::from(last != truth);
            differ += u32::from(first != last);
        }
    }
    assert!(first_wrong > 0 && last_wrong > 0 && differ > 0, "{first_wrong} {last_wrong} {differ}");
    assert_ne!(first_wrong, last_wrong);
}

#[test]
fn overflow_leaves_a_nan_and_a_zero() {
    // With every pivot, some minor is ∞ − ∞.
    let solid = [[0.0, 0.0, 1.0], [1.0, 2.0, 3.0], [3.0, 4.0, -2.0], [5.0, -7.0, 4.0], [-2.0, 6.0, 5.0]];
    let solid = solid.map(|p| p.map(|x| 1e200 * x));
    let flat = solid.map(|[x, y, _]| [x, y]);
    macro_rules! check {
        ($($backend:expr),*) => {$(
            for (sign, estimate) in [
                ask2(&$backend, TURN, &flat),
                ask2(&$backend, Question::Incircle, &flat),
                ask3(&$backend, Question::Orient3d, &solid),
                ask3(&$backend, Question::Insphere, &solid),
            ] {
                assert!(estimate.is_nan());
                assert_eq!(sign, Sign::Zero);
            }
        )*};
    }
    check!(LAST, FIRST, Epsilon::default(), Shewchuk);
}

/// Underflow makes Shewchuk's predicates wrong, as their author states.
#[test]
fn underflow_hides_a_turn() {
    let points = [[1e-200, 0.0], [0.0, 1e-200], [0.0, 0.0]];
    assert_eq!(ask2(&Shewchuk, TURN, &points), (Sign::Zero, 0.0));
    assert_eq!(ask2(&LAST, TURN, &points), (Sign::Zero, 0.0));
}

#[test]
fn epsilon_is_strict() {
    // The determinant is the first abscissa.
    let turn = |x: f64| [[x, 0.0], [0.0, 1.0], [0.0, 0.0]];
    let epsilon = Epsilon::new(0.125).unwrap();
    assert_eq!(ask2(&epsilon, TURN, &turn(0.125)), (Sign::Positive, 0.125));
    assert_eq!(ask2(&epsilon, TURN, &turn(-0.125)), (Sign::Negative, -0.125));
    assert_eq!(ask2(&epsilon, TURN, &turn(0.125f64.next_down())).0, Sign::Zero);
    assert_eq!(ask2(&epsilon, TURN, &turn(-0.125f64.next_down())).0, Sign::Zero);
    assert_eq!(ask2(&epsilon, Question::Compare(Axis::X), &turn(0.1)).0, Sign::Zero);
    assert_eq!(ask2(&epsilon, Question::Compare(Axis::X), &turn(-0.2)).0, Sign::Negative);
    let none = Epsilon::new(0.0).unwrap();
    assert_eq!(ask2(&none, TURN, &turn(5e-324)).0, Sign::Positive);
}

#[test]
fn what_is_no_epsilon_is_refused() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1e-10, -5e-324] {
        let refused: BadEpsilon = Epsilon::new(bad).unwrap_err();
        assert!(refused.to_string().contains("not a valid epsilon"), "{refused}");
    }
    for good in [0.0, -0.0, 5e-324, 1e-10, f64::MAX] {
        let name = Epsilon::new(good).unwrap().name();
        let read: f64 = name.strip_prefix("epsilon:").unwrap().parse().unwrap();
        assert_eq!(read.to_bits(), good.abs().to_bits(), "{name}");
    }
}

#[test]
fn controls_introduce_themselves_and_promise_what_they_cannot_prove() {
    fn check(backend: &impl Backend, name: &str, stage: &str) {
        assert_eq!(backend.name(), name);
        assert_eq!(backend.stages(), [stage]);
        for kind in PredicateKind::ALL {
            let contract = backend.contract(kind);
            assert!(!contract.proved && contract.zero == ZeroMeaning::Exact);
        }
        let counts = Counts::new();
        let scene = Scene::from_points2(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).unwrap();
        let session = backend.prepare(&scene, &counts).unwrap();
        let _ = session.orient2d(Plane::Xy, v(0), v(1), v(2));
        let _ = session.estimate(TURN, &[v(0), v(1), v(2)]);
        assert_eq!(session.estimate(TURN, &[v(0)]), None);
        assert_eq!(counts.get(PredicateKind::Orient2d, 0), 1, "estimates are not tallied");
        assert!(session.supports(PredicateKind::Incircle).is_ok());
        assert!(session.supports(PredicateKind::Orient3d).is_err());
        let solid = Scene::from_points3(&[[0.0; 3]]).unwrap();
        let session = backend.prepare(&solid, Off).unwrap();
        assert!(session.supports(PredicateKind::Incircle).is_err());
        assert!(session.supports(PredicateKind::Insphere).is_ok());
    }
    check(&LAST, "naive", "float");
    check(&FIRST, "naive:first", "float");
    check(&Epsilon::default(), "epsilon:1e-10", "float");
    check(&Shewchuk, "shewchuk", "adaptive");
    assert_eq!(Naive::default(), LAST);
}

/// Without rounding, a constructed vertex is the exact point.
#[test]
fn constructed_vertices_are_points_once_they_are_computed() {
    let mut plane = Scene::from_points2(&[[0.0, 0.0], [4.0, 2.0], [0.0, 4.0], [4.0, -2.0]]).unwrap();
    let x = plane.construct(Construction::Ssi([[v(0), v(1)], [v(2), v(3)]])).unwrap();
    assert_eq!(constructed(&plane), [2.0, 1.0]);
    let corners =
        [[0.0, 0.0, 1.0], [4.0, 0.0, 1.0], [0.0, 4.0, 1.0], [1.0, 2.0, -1.0], [1.0, 2.0, 3.0], [1.0, 0.0, 5.0]];
    let mut space = Scene::from_points3(&corners).unwrap();
    let y = space.construct(Construction::Lpi { line: [v(3), v(4)], plane: [v(0), v(1), v(2)] }).unwrap();
    let z = space.construct(Construction::Tpi([[v(0), v(1), v(2)], [v(3), v(4), v(5)], [v(0), v(3), v(4)]])).unwrap();
    assert_eq!(constructed(&space), [1.0, 2.0, 1.0, 1.0, 2.0, 1.0]);
    macro_rules! check {
        ($($backend:expr),*) => {$(
            let backend = $backend;
            let session = backend.prepare(&plane, Off).unwrap();
            assert_eq!(session.orient2d(Plane::Xy, v(0), v(1), x), Sign::Zero);
            assert_eq!(session.orient2d(Plane::Xy, x, v(1), v(2)), Sign::Positive);
            assert_eq!(session.estimate(TURN, &[x, v(1), v(2)]), Some(8.0));
            assert_eq!(session.compare(Axis::Y, x, v(1)), Sign::Negative);
            let session = backend.prepare(&space, Off).unwrap();
            assert_eq!(session.compare(Axis::X, y, z), Sign::Zero);
            assert_eq!(session.orient2d(Plane::Zx, y, v(3), z), Sign::Zero);
            assert_eq!(session.orient3d(v(0), v(1), v(2), y), Sign::Zero);
            assert_eq!(session.estimate(Question::Orient3d, &[v(0), v(1), z, v(3)]), Some(16.0));
        )*};
    }
    check!(LAST, FIRST, Epsilon::default(), Shewchuk);
}

/// A rounded vertex is another point, which exact predicates cannot correct.
#[test]
fn a_rounded_vertex_is_beside_its_own_line() {
    let points = [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.0], [2.0, 0.0], [2.0, 5.0]];
    let mut scene = Scene::from_points2(&points).unwrap();
    let third = scene.construct(Construction::Ssi([[v(0), v(1)], [v(2), v(3)]])).unwrap();
    let nowhere = scene.construct(Construction::Ssi([[v(0), v(2)], [v(4), v(5)]])).unwrap();
    let session = Shewchuk.prepare(&scene, Off).unwrap();
    assert!(constructed(&scene)[..2].iter().all(|x| (x - 1.0 / 3.0).abs() < 1e-15));
    assert_ne!(session.orient2d(Plane::Xy, v(2), v(3), third), Sign::Zero, "a third is no double");
    assert_eq!(session.rounded_point(third), Some(&constructed(&scene)[..2]));
    assert_eq!(session.rounded_point(v(0)), None, "it is not rounded");
    assert!(session.rounded_point(nowhere).unwrap().iter().all(|x| !x.is_finite()));
    let parallel = [v(0), nowhere, v(3)];
    assert!(session.estimate(TURN, &parallel).unwrap().is_nan(), "parallel lines make no point, and it shows");
    assert_eq!(TURN.ask(&session, &parallel), Sign::Zero);
}

/// A circle through a constructed vertex passes through the doubles of its rounded point.
#[test]
fn circles_go_through_rounded_vertices() {
    // The diagonals meet in (2, 2), which is on the circle of the first three corners of a small square beside it.
    let points = [[0.0, 0.0], [4.0, 4.0], [0.0, 4.0], [4.0, 0.0], [3.0, 2.0], [3.0, 3.0], [2.0, 3.0], [1.0, 1.5]];
    let scene = Scene::from_points2(&points).unwrap();
    let mut session = LAST.prepare(&scene, Off).unwrap();
    let centre = session.construct(&[Construction::Ssi([[v(0), v(1)], [v(2), v(3)]])]).unwrap()[0];
    let ask = |d: Vertex| session.incircle(v(4), v(5), v(6), d);
    assert_eq!([ask(centre), ask(v(7)), ask(v(5))], [Sign::Zero, Sign::Negative, Sign::Zero]);
    assert_eq!(session.incircle(v(4), v(5), centre, v(6)), Sign::Zero);
    assert_eq!(session.estimate(Question::Incircle, &[v(4), v(5), v(6), centre]), Some(0.0));
}
