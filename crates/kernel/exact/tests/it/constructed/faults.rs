//! Tests that planted faults are detected.

use predicament_exact::constructed::{
    Constructed, EXACT,
    filter::{self, Approximate},
    tight,
};
use predicament_predicates::{Construction, Dimension, Plane, Scene, Sign, Vertex};

use super::judge::Judge;
use super::scenes::{distinct, scene};
use crate::common::Random;

/// The error factor of rounded constructed vertices.
const ERRORS: f64 = 65.0 / 64.0;

/// The number of wrong answers of filters about points near lines through constructed vertices.
///
/// The points are just beyond 1024, where doubles are relatively coarsest. `errors` are granted to constructed
/// vertices, and the bound is divided by `divisor`.
fn lies(errors: f64, divisor: f64) -> usize {
    let mut random = Random(20);
    let mut lies = 0;
    for _ in 0..4000 {
        let mut scene = scene(&mut random, Dimension::Two, 4, |random| 1024.0 + random.unit());
        let v = Vertex::input;
        let Ok(x) = scene.construct(Construction::Ssi([[v(0), v(1)], [v(2), v(3)]])) else { continue };
        // Beyond the vertex, seen from the first one, on the same line up to rounding.
        let middle = Constructed::new(&scene).expect("a point").approximation(x).to_vec();
        let beyond: Vec<f64> = middle.iter().zip(scene.point(v(0))).map(|(m, a)| m + 0.75 * (m - a)).collect();
        let mut wider = Scene::new(Dimension::Two, [scene.coordinates(), &beyond].concat()).expect("finite");
        let x = wider.construct(*scene.construction(x).expect("just made")).expect("the same vertices");
        let truth = Judge::new(&wider).orient2d(Plane::Xy, [v(0), x, v(4)]);
        let ours = Constructed::new(&wider).expect("a point");
        let at = |v: Vertex| {
            let errors = if v.is_constructed() { errors } else { 0.0 };
            [0, 1].map(|i| Approximate::within(ours.approximation(v)[i], errors))
        };
        let answer = filter::orient2d(at(v(0)), at(x), at(v(4)), filter::ORIENT2D / divisor);
        lies += usize::from(answer.is_some_and(|sign| sign != truth));
    }
    lies
}

#[test]
fn a_filter_that_forgets_the_approximation_is_caught() {
    assert_eq!(lies(ERRORS, 1.0), 0);
    assert!(lies(0.0, 1.0) > 100);
    assert!(lies(ERRORS, 6.0) > 10, "granted errors of both ends add up, and M counts |d| beside");
}

/// Points found by hill climbing towards wrong signs (see bounds.rs), with a constructed pivot.
///
/// Rounding gives them a determinant of 2.7 u (of 3).
#[test]
fn half_of_orient2d_is_caught() {
    let [x, y] = [0.00011914968490606137, 5.779852929599067e-9];
    let mut scene = Scene::from_points2(&[
        [-0.5480837617636191, -1.000830015377735],
        [0.5544184476308657, 1.0119599324884534],
        [x, -1.0],
        [x, 1.0],
        [-1.0, y],
        [1.0, y],
    ])
    .expect("finite");
    let v = Vertex::input;
    let pivot = scene.construct(Construction::Ssi([[v(2), v(3)], [v(4), v(5)]])).expect("input vertices");
    let ours = Constructed::new(&scene).expect("a point");
    assert_eq!(ours.approximation(pivot), [x, y], "representable, and so not rounded");
    let truth = Judge::new(&scene).orient2d(Plane::Xy, [v(0), v(1), pivot]);
    let at = |v: Vertex, errors| [0, 1].map(|i| Approximate::within(ours.approximation(v)[i], errors));
    let answer = |bound| filter::orient2d(at(v(0), 0.0), at(v(1), 0.0), at(pivot, ERRORS), bound);
    assert_eq!(answer(filter::ORIENT2D), None);
    assert_eq!(answer(filter::ORIENT2D / 2.0), Some(-truth));
    assert_eq!(tight::orient2d(at(v(0), 0.0), at(v(1), 0.0), at(pivot, ERRORS)), None);
    assert_eq!(ours.orient2d(Plane::Xy, v(0), v(1), pivot), (truth, EXACT));
}

/// The same in space, with input vertices: determinants of 4.2 u (of 7).
#[test]
fn half_of_orient3d_is_caught() {
    let points = [
        [0.9999999999996937, -0.509341678342232, -0.5093534168920598],
        [1.0000000000000007, -1.0000057220459002, -1.0000006332643216],
        [0.5000000018778371, -2.0005493317261, 0.24999199854214108],
        [1.0000000001371407, 7.525783798351117e-5, 4.604820591075365e-5],
    ];
    let scene = Scene::from_points3(&points).expect("finite");
    let truth = Judge::new(&scene).orient3d([0, 1, 2, 3].map(Vertex::input));
    let [a, b, c, d] = points.map(|p| p.map(|x| Approximate::within(x, 0.0)));
    assert_eq!(filter::orient3d(a, b, c, d, filter::ORIENT3D), None);
    assert_eq!(filter::orient3d(a, b, c, d, filter::ORIENT3D / 2.0), Some(-truth));
    assert_eq!(tight::orient3d(a, b, c, d), None);
}

/// The filter does not answer if something overflows, underflows or is unknown.
#[test]
fn the_filter_does_not_answer_out_of_range() {
    let point = |coordinates: [f64; 3]| coordinates.map(|x| Approximate::within(x, 0.0));
    let corner = |scale: f64| [[scale, 0.0, 0.0], [0.0, scale, 0.0], [0.0, 0.0, scale], [0.0; 3]].map(point);
    let side = |scale| {
        let [a, b, c, d] = corner(scale);
        let answer = filter::orient3d(a, b, c, d, filter::ORIENT3D);
        assert_eq!(tight::orient3d(a, b, c, d), answer);
        answer
    };
    assert_eq!([1.0, 1e-80, 1e100].map(side), [Some(Sign::Positive); 3]);
    assert_eq!([1e-110, 5e-324, 0.0, 1e103, f64::MAX, f64::NAN, f64::INFINITY].map(side), [None; 7]);
}

/// Half of all weights are negative before rows are negated.
///
/// Answers without the sign of the weight would be wrong.
#[test]
fn a_dropped_weight_sign_is_caught() {
    let mut random = Random(21);
    let mut wrong = 0;
    for _ in 0..200 {
        let mut scene = scene(&mut random, Dimension::Two, 7, Random::unit);
        let [a, b, c, d]: [Vertex; 4] = distinct(&mut random, 4);
        let x = scene.construct(Construction::Ssi([[a, b], [c, d]])).expect("input vertices");
        let Some(&Construction::Ssi([[a, b], [c, d]])) = scene.construction(x) else { unreachable!("as constructed") };
        let [a, b, c, d] = [a, b, c, d].map(|v| scene.point2(Plane::Xy, v));
        let weight = Sign::of((b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0]));
        let query = [x, Vertex::input(5), Vertex::input(6)];
        let truth = Judge::new(&scene).orient2d(Plane::Xy, query);
        let ours = Constructed::new(&scene).expect("a point").orient2d_exactly(Plane::Xy, query);
        assert_eq!(ours, truth);
        wrong += usize::from(ours * weight != truth);
    }
    assert!(wrong > 50 && wrong < 150, "{wrong}");
}
