//! Dyadic evaluation against the judge, on any finite doubles, whatever rung would answer them.

use std::collections::BTreeMap;

use crate::common::{self, Random, every, nudge, points};
use predicament_effort::{scaled, whole};
use predicament_exact::dyadic;
use predicament_predicates::Sign;
use proptest::prelude::*;

fn check_orient2d(points: &[[f64; 2]; 3]) -> Sign {
    let truth = common::orient2d(points);
    let [a, b, c] = *points;
    assert_eq!(dyadic::orient2d(a, b, c), truth, "orient2d {points:?}");
    truth
}

fn check_orient3d(points: &[[f64; 3]; 4]) -> Sign {
    let truth = common::orient3d(points);
    let [a, b, c, d] = *points;
    assert_eq!(dyadic::orient3d(a, b, c, d), truth, "orient3d {points:?}");
    truth
}

fn check_incircle(points: &[[f64; 2]; 4]) -> Sign {
    let truth = common::incircle(points);
    let [a, b, c, d] = *points;
    assert_eq!(dyadic::incircle(a, b, c, d), truth, "incircle {points:?}");
    truth
}

fn check_insphere(points: &[[f64; 3]; 5]) -> Sign {
    let truth = common::insphere(points);
    let [a, b, c, d, e] = *points;
    assert_eq!(dyadic::insphere(a, b, c, d, e), truth, "insphere {points:?}");
    truth
}

/// The signs seen of all four predicates, on numbers from one source.
#[derive(Default)]
struct Seen([BTreeMap<Sign, usize>; 4]);

impl Seen {
    fn check(&mut self, random: &mut Random, value: &mut impl FnMut(&mut Random) -> f64) {
        let signs = [
            check_orient2d(&random.points(&mut *value)),
            check_orient3d(&random.points(&mut *value)),
            check_incircle(&random.points(&mut *value)),
            check_insphere(&random.points(&mut *value)),
        ];
        self.count(signs);
    }

    fn count(&mut self, signs: [Sign; 4]) {
        for (seen, sign) in self.0.iter_mut().zip(signs) {
            *seen.entry(sign).or_default() += 1;
        }
    }

    /// Checks that all signs occurred: a test that only sees one sign tests nothing.
    fn assert_all(&self, least: usize) {
        for (i, seen) in self.0.iter().enumerate() {
            assert!(seen.len() == 3 && seen.values().all(|&n| n >= least), "predicate {i}: {:?}", self.0);
        }
    }
}

/// A double with this many random leading bits and an exponent in this range.
fn wide(random: &mut Random, bits: usize, exponents: std::ops::Range<i32>) -> f64 {
    let significand = 1 + random.below(1 << bits);
    let span = usize::try_from(exponents.end - exponents.start).unwrap();
    let exponent = exponents.start + i32::try_from(random.below(span)).unwrap();
    #[allow(clippy::cast_precision_loss)] // 53 bits at most
    let magnitude = significand as f64 * 2f64.powi(exponent.max(-1000)) * 2f64.powi((exponent + 1000).min(0));
    if random.below(2) == 0 { magnitude } else { -magnitude }
}

#[test]
fn ordinary_numbers() {
    let mut random = Random(1);
    let mut seen = Seen::default();
    for _ in 0..scaled(10_000) {
        seen.check(&mut random, &mut Random::unit);
        seen.check(&mut random, &mut |random| 0.1 * [-1.0, 0.0, 1.0, 2.0][random.below(4)]);
    }
    seen.assert_all(scaled(1000));
}

/// Every span of exponents, so every size of number and both sides of each limit between sizes.
#[test]
fn mixed_exponents_of_every_span() {
    let mut random = Random(2);
    let mut seen = Seen::default();
    for round in 0..40_000 {
        let span = 1 + (round % 2045);
        // By default every span five times, and the short ones always: only similar numbers have ties.
        if !whole() && span > 8 && round / 2045 % 4 != 0 {
            continue;
        }
        let low = -1074 + i32::try_from(random.below(usize::try_from(2046 - span).unwrap())).unwrap();
        let bits = *random.pick(&[1, 2, 20, 52]);
        seen.check(&mut random, &mut |random| wide(random, bits, low..low + span).clamp(-f64::MAX, f64::MAX));
    }
    seen.assert_all(1);
}

/// The longest numbers of each size, and the shortest of the next.
#[test]
fn both_sides_of_each_limit_between_sizes() {
    let mut random = Random(6);
    for bits in [63, 64, 251, 252, 253, 254, 255, 256, 300] {
        let mut seen = Seen::default();
        for low in [-1074, -64, 17, 400] {
            // At most 2^(low + bits), one bit at 2^low.
            let [one, top] = [2f64.powi(low / 2) * 2f64.powi(low - low / 2), 2f64.powi(low + bits - 53)];
            let longest = top * (2f64.powi(53) - 1.0);
            let values = [one, -one, 0.0, longest, -longest, longest - 2.0 * top, 3.0 * one, -top];
            for _ in 0..scaled(1000) {
                seen.check(&mut random, &mut |random| *random.pick(&values));
            }
        }
        seen.assert_all(scaled(20));
    }
}

#[test]
fn wild_grids_exhaustively() {
    let mut zeros = [0; 4];
    // One in five: no grid has a multiple of five values, so every digit of every place has its turn.
    let (each, mut turn) = (predicament_effort::some_or_all(5, 1), 0);
    let mut mine = || {
        turn = (turn + 1) % each;
        turn == 0
    };
    let grids = [[0.0, 1.0, 2.0], [-5e-324, 0.0, 5e-324], [-f64::MAX, 1.0, f64::MAX], [1.0, -0.0, 1e-170]];
    for values in grids {
        every::<3, 2>(&values, |p| zeros[0] += usize::from(mine() && check_orient2d(p).is_zero()));
        every::<4, 2>(&values, |p| zeros[1] += usize::from(mine() && check_incircle(p).is_zero()));
        every::<4, 3>(&values[..2], |p| zeros[2] += usize::from(mine() && check_orient3d(p).is_zero()));
        every::<5, 3>(&values[1..], |p| zeros[3] += usize::from(mine() && check_insphere(p).is_zero()));
    }
    every::<3, 2>(&[5e-324, -0.0, f64::MIN_POSITIVE, 1e-160, 1.0, -1e155, f64::MAX], |p| {
        if mine() {
            check_orient2d(p);
        }
    });
    every::<4, 2>(&[-5e-324, 1.1e-80, 3.0, 1e308], |p| {
        if mine() {
            check_incircle(p);
        }
    });
    assert!(zeros.iter().all(|&count| count > 1000 / each), "grids are full of ties: {zeros:?}");
}

/// Points that are degenerate except for rounding and a few ulps.
///
/// They are anywhere on the exponent scale, and with axes of different scales.
#[test]
fn nearly_degenerate_at_every_scale() {
    let mut random = Random(3);
    let mut seen = Seen::default();
    for round in 0..scaled(20_000) {
        let common = wide(&mut random, 1, -1020..1000);
        // Axes stretched by powers of two keep lines and planes.
        let scales: [f64; 3] =
            std::array::from_fn(|_| if round % 2 == 0 { common } else { wide(&mut random, 1, -1000..1000) });
        let shift = if round % 3 == 0 { 0.0 } else { random.unit() };
        let at = |random: &mut Random, scale: f64, x: f64| {
            nudge(scale * (shift + x) / 16.0, [0, 0, 1, -1, 3][random.below(5)])
        };
        let [p, q, r]: [[f64; 3]; 3] = random.points(Random::unit);
        let [s, t] = [random.unit(), random.unit()];
        let on_plane: [f64; 3] = std::array::from_fn(|i| p[i] + s * (q[i] - p[i]) + t * (r[i] - p[i]));
        let on_line: [f64; 3] = std::array::from_fn(|i| p[i] + s * (q[i] - p[i]));
        let line = [p, q, on_line].map(|p| [0, 1].map(|i| at(&mut random, scales[i], p[i])));
        let plane = [p, q, r, on_plane].map(|p| [0, 1, 2].map(|i| at(&mut random, scales[i], p[i])));
        let mut on_sphere = |flat: bool| {
            let [x, y, z] = std::array::from_fn(|_| random.unit() - 0.5);
            let z = if flat { 0.0 } else { z };
            let length = (x * x + y * y + z * z).sqrt();
            [x, y, z].map(|x: f64| at(&mut random, common, x / length))
        };
        let circle: [[f64; 3]; 4] = std::array::from_fn(|_| on_sphere(true));
        let sphere: [[f64; 3]; 5] = std::array::from_fn(|_| on_sphere(false));
        let circle = circle.map(|[x, y, _]| [x, y]);
        seen.count([check_orient2d(&line), check_orient3d(&plane), check_incircle(&circle), check_insphere(&sphere)]);
    }
    let positive_and_negative = |seen: &BTreeMap<Sign, usize>| seen[&Sign::Positive].min(seen[&Sign::Negative]);
    assert!(seen.0.iter().all(|seen| positive_and_negative(seen) > scaled(1000)), "{:?}", seen.0);
}

/// Exact ties between the longest numbers, and one bit beside the tie.
///
/// The differences are the widest that doubles have, so no approximation helps.
#[test]
fn ties_of_the_longest_numbers() {
    let mut random = Random(4);
    let mut seen = Seen::default();
    for _ in 0..scaled(4000) {
        // Vectors with a coordinate from each end of the scale, so sums of them are long.
        let mut value = |random: &mut Random| match random.below(3) {
            0 => wide(random, 52, -1074..-1060),
            1 => wide(random, 52, -40..10),
            _ => wide(random, 51, 950..960),
        };
        let [p, q]: [[f64; 3]; 2] = random.points(&mut value);
        // With the last coordinate equal to the first, everything is on one plane, line or circle's axis.
        let flat = |[x, y, _]: [f64; 3]| [x, y, x];
        let [r, s]: [[f64; 3]; 2] = random.points(&mut value);
        let off = |p: [f64; 3], random: &mut Random| [p[0], p[1], nudge(p[2], [0, 0, 1, -1][random.below(4)])];
        let plane = [flat(p), off(flat(q), &mut random), flat(r), flat(s)];
        let line = [[p[0], p[0]], [q[0], q[0]], [r[1], nudge(r[1], [0, 0, 1, -1][random.below(4)])]];
        // Corners of a box lie on a circle, and on a sphere.
        let corner = |x: usize, y: usize, z: usize| [[p, q][x][0], [p, q][y][1], [p, q][z][2]];
        let circle = [corner(0, 0, 0), corner(1, 0, 0), corner(1, 1, 0), off2(corner(0, 1, 0), &mut random)];
        let sphere =
            [corner(0, 0, 0), corner(1, 0, 0), corner(0, 1, 0), corner(0, 0, 1), off(corner(1, 1, 1), &mut random)];
        seen.count([
            check_orient2d(&line),
            check_orient3d(&plane),
            check_incircle(&circle.map(|[x, y, _]| [x, y])),
            check_insphere(&sphere),
        ]);
    }
    seen.assert_all(scaled(100));
}

fn off2([x, y, z]: [f64; 3], random: &mut Random) -> [f64; 3] {
    [x, nudge(y, [0, 0, 1, -1][random.below(4)]), z]
}

/// The longest intermediates of all: the ends of the scale with every sign.
#[test]
fn nothing_is_too_long() {
    let ends = [f64::MAX, -f64::MAX, 5e-324, -5e-324, f64::MAX - f64::MAX / 3.0, f64::MIN_POSITIVE.next_down()];
    let mut random = Random(5);
    let mut seen = Seen::default();
    for _ in 0..scaled(10_000) {
        seen.check(&mut random, &mut |random| *random.pick(&ends));
    }
    seen.assert_all(scaled(100));
}

/// Ties in which every difference has the maximum number of bits.
///
/// Each point but one is at the upper end of the scale, the other at the lower end.
#[test]
fn every_difference_is_as_long_as_it_gets() {
    let mut random = Random(6);
    let mut seen = Seen::default();
    for _ in 0..scaled(4000) {
        let mut far = |random: &mut Random| wide(random, 53, 971..972);
        let [p, q, r, s]: [[f64; 3]; 4] = random.points(&mut far);
        let near: [f64; 3] = std::array::from_fn(|_| wide(&mut random, 53, -1074..-1073));
        // With the last coordinate equal to the first, vectors are on one plane, whatever the others are.
        let flat = |[x, y, _]: [f64; 3]| [x, y, x];
        let fourth = if random.below(2) == 0 { p } else { s };
        let mut beside = |p: [f64; 3]| [p[0], p[1], nudge(p[2], [0, 0, 1, -1][random.below(4)])];
        let plane = [flat(p), flat(q), beside(flat(r)), flat(near)];
        let line = [[p[0], p[0]], [q[0], beside(flat(q))[2]], [near[0], near[0]]];
        // A point that occurs twice, or nearly, is on every circle and sphere of the others.
        let twice = [p, q, beside(p)].map(|[x, _, z]| [x, z]);
        let circle = [twice[0], twice[1], twice[2], [near[0], near[1]]];
        let sphere = [p, q, r, beside(fourth), near];
        seen.count([check_orient2d(&line), check_orient3d(&plane), check_incircle(&circle), check_insphere(&sphere)]);
    }
    seen.assert_all(scaled(100));
}

#[test]
#[should_panic(expected = "finite")]
fn infinity_is_refused() {
    let _ = dyadic::orient2d([0.0, 1.0], [f64::INFINITY, 0.0], [1.0, 1.0]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(4000)))]

    #[test]
    fn arbitrary_doubles(
        triangle in points::<3, 2>(),
        tetrahedron in points::<4, 3>(),
        circle in points::<4, 2>(),
        sphere in points::<5, 3>(),
    ) {
        check_orient2d(&triangle);
        check_orient3d(&tetrahedron);
        check_incircle(&circle);
        check_insphere(&sphere);
    }
}
