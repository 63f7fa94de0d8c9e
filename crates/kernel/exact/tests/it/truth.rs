//! All five predicates against the judge: ordinary, degenerate and extreme numbers.

use std::collections::BTreeSet;

use crate::common::{
    Random, check_incircle, check_insphere, check_orient2d, check_orient3d, check_projections, every, nudge, points,
};
use predicament_arithmetic::{Arithmetic, Plan};
use predicament_effort::scaled;
use predicament_exact::determinant;
use predicament_predicates::Sign;
use proptest::prelude::*;

/// Magnitudes from the least subnormal to the largest double, with long and short significands.
const WILD: [f64; 12] =
    [5e-324, 3.0e-310, f64::MIN_POSITIVE, -1.1e-308, 1e-200, -1.0, 0.1, 3e15, -1e102, 1.7e154, -1e308, f64::MAX];

#[test]
fn uniform() {
    let mut random = Random(1);
    for _ in 0..scaled(3000) {
        check_orient2d(&random.points(Random::unit));
        check_orient3d(&random.points(Random::unit));
        check_incircle(&random.points(Random::unit));
        check_insphere(&random.points(Random::unit));
        check_projections(&random.points(Random::unit));
    }
}

#[test]
fn small_grids_exhaustively() {
    let (mut zeros, mut effort) = ([0; 4], Random(8));
    // Of many queries, one of this many runs.
    let mut is_left_out = || effort.below(predicament_effort::divisor()) > 0;
    for values in [[0.0, 1.0, 2.0], [0.1, 0.2, 0.3], [-5e-324, 0.0, 5e-324], [1e300, 2e300, 3e300], [1.0, -0.0, 1e-170]]
    {
        every::<3, 2>(&values, |p| zeros[0] += usize::from(check_orient2d(p).is_zero()));
        every::<4, 2>(&values, |p| zeros[1] += usize::from(!is_left_out() && check_incircle(p).is_zero()));
        every::<3, 3>(&values, |p| {
            if !is_left_out() {
                check_projections(p)
            }
        });
        every::<4, 3>(&values[..2], |p| zeros[2] += usize::from(check_orient3d(p).is_zero()));
        every::<5, 3>(&values[1..], |p| zeros[3] += usize::from(!is_left_out() && check_insphere(p).is_zero()));
    }
    // No orient2d or orient3d query is left out.
    let least = [1000, scaled(10_000), 10_000, scaled(100_000)];
    assert!(zeros.iter().zip(least).all(|(&count, least)| count > least), "grids are full of ties: {zeros:?}");
}

#[test]
fn every_exponent_with_every_other() {
    let mut effort = Random(9);
    // One in five by default.
    let mut is_left_out = || effort.below(predicament_effort::some_or_all(5, 1)) > 0;
    every::<3, 2>(&[5e-324, 0.0, 1e-160, 1.0, -1e155, f64::MAX], |p| {
        if !is_left_out() {
            check_orient2d(p);
        }
    });
    every::<4, 2>(&[-5e-324, 1.1e-80, 1e308], |p| {
        if !is_left_out() {
            check_incircle(p);
        }
    });
    let mut random = Random(2);
    let mut signs = BTreeSet::new();
    let mut wild = |random: &mut Random| *random.pick(&WILD);
    for _ in 0..predicament_effort::some_or_all(200, 10_000) {
        signs.insert((0, check_orient2d(&random.points(&mut wild))));
        signs.insert((1, check_orient3d(&random.points(&mut wild))));
        signs.insert((2, check_incircle(&random.points(&mut wild))));
        signs.insert((3, check_insphere(&random.points(&mut wild))));
        check_projections(&random.points(&mut wild));
    }
    assert_eq!(signs.len(), 12, "all three signs of each predicate");
}

/// Points that are degenerate except for rounding and a few ulps, anywhere on the exponent scale.
///
/// The limits of the plan lie in between.
#[test]
fn nearly_degenerate_at_every_scale() {
    let mut random = Random(3);
    let near = |random: &mut Random, x: f64| nudge(x, i64::try_from(random.below(9)).unwrap() - 4);
    for round in 0..predicament_effort::scaled(12_000) {
        let scale =
            2f64.powi(i32::try_from(random.below(2040)).unwrap() - 1020) * if round % 2 == 0 { 1.0 } else { 3.0 };
        let shift = if round % 3 == 0 { 0.0 } else { random.unit() };
        let scaled = |x: f64| scale * (shift + x);
        let at = |random: &mut Random, x: f64| near(random, scaled(x) / 16.0);

        let [p, q, r]: [[f64; 3]; 3] = random.points(Random::unit);
        let [s, t] = [random.unit(), random.unit()];
        let on_line: [f64; 2] = std::array::from_fn(|i| p[i] + s * (q[i] - p[i]));
        let on_plane: [f64; 3] = std::array::from_fn(|i| p[i] + s * (q[i] - p[i]) + t * (r[i] - p[i]));
        check_orient2d(&[[p[0], p[1]], [q[0], q[1]], on_line].map(|p| p.map(|x| at(&mut random, x))));
        check_orient3d(&[p, q, r, on_plane].map(|p| p.map(|x| at(&mut random, x))));

        let mut on_sphere = |flat: bool| {
            let [x, y, z] = std::array::from_fn(|_| random.unit() - 0.5);
            let z = if flat { 0.0 } else { z };
            let length = (x * x + y * y + z * z).sqrt();
            [x, y, z].map(|x: f64| near(&mut random, scaled(x / length) / 16.0))
        };
        let circle: [[f64; 3]; 4] = std::array::from_fn(|_| on_sphere(true));
        let sphere: [[f64; 3]; 5] = std::array::from_fn(|_| on_sphere(false));
        check_incircle(&circle.map(|[x, y, _]| [x, y]));
        check_insphere(&sphere);
    }
}

/// Integers of the largest size for which a rung suffices, and of the next size.
///
/// They are as large as possible, and some determinants are small.
#[test]
fn numbers_to_the_last_bit_of_each_rung() {
    let mut random = Random(11);
    for determinant in [determinant::ORIENT2D, determinant::ORIENT3D, determinant::INCIRCLE, determinant::INSPHERE] {
        let exact_in_doubles = (53 - determinant.form.growth) / determinant.form.degree;
        for (bits, arithmetic, next) in [
            (exact_in_doubles, Arithmetic::Double, Arithmetic::Integer),
            (62, Arithmetic::Integer, Arithmetic::WideInteger),
            (126, Arithmetic::WideInteger, Arithmetic::Dyadic),
        ] {
            let chosen = |bits: i32| Plan::of(&[[0.0], [1.0], [largest(bits)]]).arithmetic(determinant.form);
            assert_eq!([chosen(bits), chosen(bits + 1)], [arithmetic, next]);
        }
        for bits in [exact_in_doubles, exact_in_doubles + 1, 53, 54, 62, 63, 126, 127] {
            for _ in 0..scaled(1000) {
                let mut extreme = |random: &mut Random| {
                    // Corners of the range, their halves, and the lowest bit.
                    let corner = random.pick(&[0.0, 1.0, 0.5, 0.75].map(|part| part * largest(bits))).trunc();
                    (corner + *random.pick(&[0.0, 0.0, 1.0, -1.0])).clamp(0.0, largest(bits))
                };
                match determinant {
                    determinant::ORIENT2D => drop(check_orient2d(&random.points(&mut extreme))),
                    determinant::ORIENT3D => drop(check_orient3d(&random.points(&mut extreme))),
                    determinant::INCIRCLE => drop(check_incircle(&random.points(&mut extreme))),
                    _ => drop(check_insphere(&random.points(&mut extreme))),
                }
            }
        }
    }
}

/// The largest double below 2^bits that is an integer.
fn largest(bits: i32) -> f64 {
    if bits < 53 { 2f64.powi(bits) - 1.0 } else { 2f64.powi(bits).next_down() }
}

/// Five points of a sphere with integer coordinates, moved far from the origin.
///
/// They are exact ties that no filter can prove.
#[test]
fn hidden_ties() {
    let corners = [[1, 2, 2], [2, 1, -2], [-2, 2, 1], [0, -3, 0], [0, 0, 3], [-1, 2, -2]];
    for shift in [0.0, 1e6, 4503599627370496.0, 0.75] {
        for scale in [1.0, 2f64.powi(-500), 2f64.powi(900), f64::from_bits(16)] {
            // Every product and sum here is exact.
            let on = |i: usize| corners[i].map(|x| (f64::from(x) * 4.0 + shift) * scale);
            assert_eq!(check_insphere(&[on(0), on(1), on(2), on(3), on(4)]), Sign::Zero);
            assert_eq!(check_insphere(&[on(5), on(1), on(2), on(4), on(3)]), Sign::Zero);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(2000)))]

    #[test]
    fn arbitrary_doubles(
        triangle in points::<3, 2>(),
        projected in points::<3, 3>(),
        tetrahedron in points::<4, 3>(),
        circle in points::<4, 2>(),
        sphere in points::<5, 3>(),
    ) {
        check_orient2d(&triangle);
        check_projections(&projected);
        check_orient3d(&tetrahedron);
        check_incircle(&circle);
        check_insphere(&sphere);
    }
}
