//! Constructed vertices in the limit.
//!
//! If there is a point, the limit is the point. If there is none before the move, the limit is compared with small
//! numbers in place of infinitesimals.

use crate::common::substitution::{between, moved, side, turn};
use crate::common::{Random, grid_scene, scene};
use predicament_predicates::{Construction, Scene, Vertex};
use predicament_sos::Ratio;
use rug::{Integer, Rational, integer::Order};

/// The limit, in rationals of GMP.
#[derive(Debug)]
struct Limit {
    position: Vec<Option<Rational>>,
    weights: Vec<Option<Rational>>,
}

fn limit(scene: &Scene, v: Vertex) -> Option<Limit> {
    let rationals = |ratios: Vec<Option<Ratio>>| ratios.into_iter().map(|ratio| ratio.map(rational)).collect();
    let limit = predicament_sos::limit(scene, v)?;
    Some(Limit { position: rationals(limit.position), weights: rationals(limit.weights) })
}

/// The same number, and a check that it is in lowest terms.
fn rational(Ratio { numerator, denominator }: Ratio) -> Rational {
    let [n, d] = [&numerator, &denominator].map(|integer| {
        let magnitude = Integer::from_digits(integer.limbs(), Order::Lsf);
        if integer.is_negative() { -magnitude } else { magnitude }
    });
    let ratio = Rational::from((n.clone(), d.clone()));
    assert_eq!(ratio.clone().into_numer_denom(), (n, d), "lowest terms");
    ratio
}

fn ratio(n: i32, d: i32) -> Option<Rational> {
    Some(Rational::from((n, d)))
}

/// The fraction of the way to f = 0 from the values of f at both ends; `None` if they are equal.
fn way(at_p: Rational, at_q: &Rational) -> Option<Rational> {
    let whole = Rational::from(&at_p - at_q);
    (whole != 0).then(|| at_p / whole)
}

/// Asserts that a number is near the limit, or near infinity if there is none.
///
/// The numbers in place of infinitesimals are at most 2^-64.
fn assert_near(value: &Rational, limit: Option<&Rational>, context: &str) {
    let tiny = Rational::from((1, Integer::from(1) << 40));
    let near = match limit {
        Some(limit) => Rational::from(value - limit).abs() < tiny,
        None => value.clone().abs() > tiny.recip(),
    };
    assert!(near, "{value} for {limit:?}: {context}");
}

fn fractions(points: &[Vec<Rational>], construction: Construction) -> Vec<Option<Rational>> {
    let point = |v: Vertex| points[v.index()].as_slice();
    match construction {
        Construction::Ssi([[p, q], [a, b]]) => {
            let from = |a, b, x| turn(point(a), point(b), point(x));
            vec![way(from(a, b, p), &from(a, b, q)), way(from(p, q, a), &from(p, q, b))]
        }
        Construction::Lpi { line: [p, q], plane: [a, b, c] } => {
            let from = |x| side(point(a), point(b), point(c), point(x));
            let part = |x, y| side(point(p), point(q), point(x), point(y));
            let parts = [part(b, c), part(c, a), part(a, b)];
            let whole = parts.iter().sum::<Rational>();
            let share = |part| (whole != 0).then(|| Rational::from(part / &whole));
            [way(from(p), &from(q))].into_iter().chain(parts.iter().map(share)).collect()
        }
        Construction::Tpi(_) | Construction::Ratio { .. } => Vec::new(),
    }
}

/// Constructs a point and compares its limit with small numbers; returns true if it existed before the move.
fn check(mut scene: Scene, construction: Construction) -> bool {
    let at = scene.construct(construction).unwrap();
    let construction = *scene.construction(at).unwrap();
    let Limit { position, weights } = limit(&scene, at).unwrap();
    let points = moved(&scene);
    let exact = |v: Vertex| scene.point(v).iter().map(|&x| Rational::from_f64(x).unwrap()).collect::<Vec<_>>();
    let unmoved: Vec<Vec<Rational>> = scene.vertices().map(exact).collect();
    let near = fractions(&points, construction);
    assert_eq!(near.len(), weights.len());
    for (value, limit) in near.iter().zip(&weights) {
        assert_near(value.as_ref().unwrap(), limit.as_ref(), &format!("{construction} in {scene:?}"));
    }
    let there = fractions(&unmoved, construction);
    let was_there = there.iter().all(Option::is_some);
    if was_there {
        assert_eq!(weights, there, "{construction} in {scene:?}");
    }
    // The position is that fraction of the way, whether or not it is finite.
    let (p, q, t) = match construction {
        Construction::Ssi([[p, q], _]) | Construction::Lpi { line: [p, q], .. } => (p, q, near[0].clone().unwrap()),
        Construction::Tpi(_) | Construction::Ratio { .. } => return was_there,
    };
    let ends = [t.clone(), Rational::from(&t - 1)];
    let place = between(&points[p.index()], &points[q.index()], ends);
    for (value, limit) in place.iter().zip(&position) {
        assert_near(value, limit.as_ref(), &format!("{construction} in {scene:?}"));
    }
    was_there
}

#[test]
fn two_lines_that_cross_or_will() {
    let (mut random, mut counts) = (Random(31), [0; 2]);
    for _ in 0..600 {
        let scene = grid_scene(2, 3, &random.numbers(9, 4));
        let [p, q, a, b] = std::array::from_fn(Vertex::input);
        counts[usize::from(check(scene, Construction::Ssi([[p, q], [a, b]])))] += 1;
    }
    assert!(counts.iter().all(|&count| count > 100), "{counts:?}");
}

#[test]
fn a_line_and_a_plane_that_meet_or_will() {
    // By this number of samples, points exist that are not among the first few.
    let (mut random, mut counts) = (Random(33), [0; 2]);
    let rounds = predicament_effort::some_or_all(3, 100);
    for _ in 0..rounds {
        let scene = grid_scene(3, 2, &random.numbers(8, 5));
        let [p, q, a, b, c] = std::array::from_fn(Vertex::input);
        counts[usize::from(check(scene, Construction::Lpi { line: [p, q], plane: [a, b, c] }))] += 1;
    }
    assert!(counts.iter().all(|&count| count >= (rounds / 6).max(1)), "{counts:?}");
}

#[test]
fn segments_with_a_common_end_meet_there() {
    let mut random = Random(33);
    for _ in 0..200 {
        let scene = grid_scene(2, 2, &random.numbers(9, 3));
        let [p, q, a] = std::array::from_fn(Vertex::input);
        check(scene, Construction::Ssi([[p, q], [p, a]]));
    }
    // All on the y axis: the largest infinitesimal is in the weight, and squared in the row along x.
    let mut upright = scene(2, vec![0., 0., 0., 1., 0., 2.]).unwrap();
    let [p, q, a] = std::array::from_fn(Vertex::input);
    let at = upright.construct(Construction::Ssi([[p, q], [p, a]])).unwrap();
    let met = limit(&upright, at).unwrap();
    assert_eq!((met.position, met.weights), (vec![ratio(0, 1); 2], vec![ratio(0, 1); 2]));
}

/// Two segments of the x axis: (0, 4) and (1, 3). Vertex 0 is lifted most, then turned by vertex 1 alone.
#[test]
fn overlapping_segments_meet_where_the_perturbation_lifts_the_first_vertex_least() {
    let mut flat = scene(2, vec![0., 0., 4., 0., 1., 0., 3., 0.]).unwrap();
    let [p, q, a, b] = std::array::from_fn(Vertex::input);
    let at = flat.construct(Construction::Ssi([[p, q], [a, b]])).unwrap();
    // Only p leaves the line by the largest move across it: the lines meet at q.
    let met = limit(&flat, at).unwrap();
    assert_eq!((met.position, met.weights), (vec![ratio(4, 1), ratio(0, 1)], vec![ratio(1, 1), ratio(3, 2)]));
    // Parallel lines meet at no finite place.
    let mut parallel = scene(2, vec![0., 0., 4., 0., 1., 1., 3., 1.]).unwrap();
    let at = parallel.construct(Construction::Ssi([[p, q], [a, b]])).unwrap();
    let met = limit(&parallel, at).unwrap();
    assert_eq!((met.position[0].clone(), met.weights), (None, vec![None, None]));
}

#[test]
fn three_planes_meet_in_units_of_any_size() {
    let third = 1.0 / 4096.0;
    let corners =
        [[0., 0., third], [1., 0., third], [0., 1., third], [third, 0., 0.], [third, 1., 0.], [third, 0., 1.]];
    let mut points = corners.as_flattened().to_vec();
    points.extend([0., 2., 0., 1., 2., 1., 0., 2., 1.]);
    let mut cube = scene(3, points).unwrap();
    let [a, b, c, d, e, f, g, h, i] = std::array::from_fn(Vertex::input);
    let at = cube.construct(Construction::Tpi([[a, b, c], [d, e, f], [g, h, i]])).unwrap();
    let met = limit(&cube, at).unwrap();
    assert_eq!(met.position, [ratio(1, 4096), ratio(2, 1), ratio(1, 4096)]);
    assert_eq!(met.weights, []);
    // One plane twice, by other points: a line of common points, of which the move leaves one.
    let mut twice = scene(
        3,
        vec![
            0., 0., 0., 1., 0., 0., 0., 1., 0., 1., 1., 0., 2., 1., 0., 3., 2., 0., 1., 0., 5., 1., 1., 5., 1., 3., 0.,
        ],
    )
    .unwrap();
    let at = twice.construct(Construction::Tpi([[a, b, c], [d, e, f], [g, h, i]])).unwrap();
    let met = limit(&twice, at).unwrap();
    assert_eq!([&met.position[0], &met.position[2]], [&ratio(1, 1), &ratio(0, 1)], "on both planes: {met:?}");
}
