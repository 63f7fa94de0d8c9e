//! A batch answers as single queries do, bit by bit; single queries answer by the formulas and bands.

use std::collections::BTreeSet;

use predicament_predicates::{
    Axis, Backend, Counts, Dimension, Off, Plane, PredicateKind, Predicates, Question, Scene, Sign, Vertex,
};
use predicament_tolerance::{Float, Tolerance, circles, quantities};
use proptest::prelude::*;

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];
const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];

/// Coordinates of one kind, or a mixture of all kinds.
///
/// The kinds are: anywhere, as close to a lattice as tolerances reach, and at the lower end of the doubles.
fn coordinate() -> impl Strategy<Value = f64> {
    let lattice = || (-3..4_i32).prop_map(f64::from);
    let near = (lattice(), -8..9_i32, 16..53_i32).prop_map(|(at, by, power)| at + f64::from(by) * 2f64.powi(-power));
    let tiny = (-9..10_i32).prop_map(|count| f64::from(count) * f64::from_bits(1));
    prop_oneof![2 => -1.0..1.0_f64, 1 => lattice(), 2 => near, 1 => tiny]
}

/// Points of a scene, all of one mixture, representable in both formats.
fn points<const D: usize>() -> impl Strategy<Value = Vec<[f64; D]>> {
    // Two far corners, so that L is a normal number.
    let with_corners = |mut points: Vec<[f64; D]>| {
        points.push([-4.0; D]);
        points.push([4.0; D]);
        points
    };
    prop::collection::vec(prop::array::uniform(coordinate()), 8..40).prop_map(with_corners)
}

/// Checks that single queries, batches and the formula agree; returns the answers.
fn check<const N: usize>(
    queries: &[[Vertex; N]],
    formula: impl Fn([Vertex; N]) -> f64,
    width: f64,
    one: impl Fn([Vertex; N]) -> Sign,
    many: impl Fn(&[[Vertex; N]], &mut [Sign]),
) -> BTreeSet<Sign> {
    let mut expected = Vec::new();
    for &query in queries {
        let value = formula(query);
        let sign = if value.abs() <= width { Sign::Zero } else { Sign::of(value) };
        assert_eq!(one(query), sign, "{query:?}: {value:e} of {width:e}");
        expected.push(sign);
    }
    let mut out = vec![Sign::Positive; queries.len()];
    many(queries, &mut out);
    assert_eq!(out, expected);
    expected.into_iter().collect()
}

/// Checks all predicates of one scene in one format.
fn check_all<F: Float>(dimension: Dimension, points: &[f64], order: &[usize]) -> BTreeSet<Sign> {
    // Numbers of the format, as the backend requires.
    let scene = Scene::new(dimension, points.iter().map(|&x| F::nearest(x).wide()).collect::<Vec<_>>()).unwrap();
    let backend = Tolerance::<F>::new();
    let session = backend.prepare(&scene, Off).unwrap();
    let vertices: Vec<Vertex> = order.iter().map(|at| Vertex::input(at % scene.len())).collect();
    let width = |question| session.band(question).unwrap().width;
    let solid = |v: Vertex| scene.point3(v).map(F::nearest);
    let mut seen = BTreeSet::new();
    for &axis in &AXES[..dimension.count()] {
        let formula = |[a, b]: [Vertex; 2]| {
            let order = scene.coordinate(axis, a).partial_cmp(&scene.coordinate(axis, b)).unwrap();
            f64::from(Sign::from(order).as_i8())
        };
        let one = |[a, b]: [Vertex; 2]| session.compare(axis, a, b);
        seen.extend(check(vertices.as_chunks().0, formula, 0.0, one, |queries, out| {
            session.compare_batch(axis, queries, out)
        }));
    }
    for &plane in if dimension == Dimension::Two { &PLANES[..1] } else { &PLANES } {
        let flat = |v: Vertex| scene.point2(plane, v).map(F::nearest);
        let formula = |[a, b, c]: [Vertex; 3]| quantities::area(&flat(c), &flat(a), &flat(b)).wide();
        let one = |[a, b, c]: [Vertex; 3]| session.orient2d(plane, a, b, c);
        let width = width(Question::Orient2d(plane));
        let queries = vertices.as_chunks().0;
        seen.extend(check(queries, formula, width, one, |queries, out| session.orient2d_batch(plane, queries, out)));
        if let &[a, b, ..] = &vertices[..] {
            let many = |points: &[[Vertex; 1]], out: &mut [Sign]| {
                session.orient2d_line(plane, [a, b], points.as_flattened(), out);
            };
            check(vertices.as_chunks().0, |[c]| formula([a, b, c]), width, |[c]| one([a, b, c]), many);
        }
    }
    if dimension == Dimension::Two {
        let flat = |v: Vertex| scene.point2(Plane::Xy, v).map(F::nearest);
        let formula = |query: [Vertex; 4]| circles::incircle(&query.map(flat)).wide();
        let one = |[a, b, c, d]: [Vertex; 4]| session.incircle(a, b, c, d);
        let many = |queries: &[_], out: &mut [Sign]| session.incircle_batch(queries, out);
        seen.extend(check(vertices.as_chunks().0, formula, width(Question::Incircle), one, many));
        return seen;
    }
    let formula = |[a, b, c, d]: [Vertex; 4]| quantities::volume(&solid(a), &solid(b), &solid(c), &solid(d)).wide();
    let one = |[a, b, c, d]: [Vertex; 4]| session.orient3d(a, b, c, d);
    let xi = width(Question::Orient3d);
    seen.extend(check(vertices.as_chunks().0, formula, xi, one, |queries, out| session.orient3d_batch(queries, out)));
    if let &[a, b, c, ..] = &vertices[..] {
        let many = |points: &[[Vertex; 1]], out: &mut [Sign]| {
            session.orient3d_plane([a, b, c], points.as_flattened(), out);
        };
        check(vertices.as_chunks().0, |[d]| formula([a, b, c, d]), xi, |[d]| one([a, b, c, d]), many);
    }
    let formula = |query: [Vertex; 5]| circles::insphere(&query.map(solid)).wide();
    let one = |[a, b, c, d, e]: [Vertex; 5]| session.insphere(a, b, c, d, e);
    let many = |queries: &[_], out: &mut [Sign]| session.insphere_batch(queries, out);
    seen.extend(check(vertices.as_chunks().0, formula, width(Question::Insphere), one, many));
    seen
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(2000)))]

    #[test]
    fn batches_answer_as_single_queries_do(
        flat in points::<2>(),
        solid in points::<3>(),
        order in prop::collection::vec(0..1000_usize, 0..500),
    ) {
        for dimension in [Dimension::Two, Dimension::Three] {
            let points = if dimension == Dimension::Two { flat.as_flattened() } else { solid.as_flattened() };
            let seen = [check_all::<f64>(dimension, points, &order), check_all::<f32>(dimension, points, &order)];
            prop_assert!(order.len() < 400 || seen.iter().all(|seen| seen.len() == 3), "{seen:?}");
        }
    }
}

#[test]
fn batches_are_tallied_and_empty_ones_are_not() {
    let scene = Scene::from_points3(&[[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]]).unwrap();
    let counts = Counts::new();
    let session = Tolerance.prepare(&scene, &counts).unwrap();
    let [a, b, c, d] = [0, 1, 2, 3].map(Vertex::input);
    let mut out = [Sign::Zero; 3];
    session.orient3d_batch(&[[a, b, c, d]; 3], &mut out);
    session.orient3d_batch(&[], &mut []);
    session.orient3d_plane([a, b, c], &[d, a], &mut out[..2]);
    session.orient2d_line(Plane::Xy, [a, b], &[], &mut []);
    assert_eq!(counts.get(PredicateKind::Orient3d, 0), 5);
    assert_eq!(counts.get(PredicateKind::Orient2d, 0), 0);
}

#[test]
#[should_panic(expected = "incircle declined: needs a 2D scene")]
fn a_batch_of_what_is_declined_panics_as_a_query_does() {
    let scene = Scene::from_points3(&[[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]]).unwrap();
    let session = Tolerance.prepare(&scene, Off).unwrap();
    session.incircle_batch(&[[0, 1, 2, 3].map(Vertex::input)], &mut [Sign::Zero]);
}

#[test]
#[should_panic(expected = "a 2D scene has no axis z")]
fn a_batch_along_no_axis_panics() {
    let scene = Scene::from_points2(&[[0., 0.], [1., 0.]]).unwrap();
    let session = Tolerance.prepare(&scene, Off).unwrap();
    session.compare_batch(Axis::Z, &[[0, 1].map(Vertex::input)], &mut [Sign::Zero]);
}
