//! Whole ladders on every query whose coordinates are of a small set, against integers.
//!
//! The functions of [`raw`] are those that users call: filters, then integers. The sets have numbers of one bit and of
//! many, far apart, so that differences and products round. Each set is tried in three sizes: as it is, in the lowest
//! subnormal numbers, where products underflow, and at the top, where they overflow.

use predicament_arithmetic::{Sign, power_of_two};
use predicament_exact::{anywhere, raw};

use crate::toy::determinant_of;

/// Queries, those with a zero, and those answered wrongly.
#[derive(Default, Debug)]
struct Count {
    all: u64,
    zeros: u64,
    wrong: u64,
}

/// Asks every `step`-th of the queries with `N` points of these coordinates, in three sizes.
#[allow(clippy::cast_precision_loss)] // below 2^53, or a power of two
fn every<const D: usize, const N: usize>(
    coordinates: &[i64],
    step: usize,
    lifted: bool,
    ask: impl Fn([[f64; D]; N]) -> Sign,
) -> [Count; 3] {
    let doubles = sizes(coordinates).map(|exponent| {
        // (In two steps: the power may be subnormal.)
        let scale = power_of_two(exponent / 2) * power_of_two(exponent - exponent / 2);
        coordinates.iter().map(|&x| x as f64 * scale).collect::<Vec<f64>>()
    });
    let mut counts = <[Count; 3]>::default();
    let most = coordinates.len().pow(u32::try_from(D * N).expect("15 at most"));
    for query in (0..most).step_by(step) {
        let mut rest = query;
        let at: [[usize; D]; N] = std::array::from_fn(|_| {
            std::array::from_fn(|_| {
                let place = rest % coordinates.len();
                rest /= coordinates.len();
                place
            })
        });
        let truth = determinant_of(&at.map(|point| point.map(|place| coordinates[place])), lifted).signum();
        for (count, doubles) in counts.iter_mut().zip(&doubles) {
            let found = ask(at.map(|point| point.map(|place| doubles[place])));
            count.all += 1;
            count.zeros += u64::from(truth == 0);
            count.wrong += u64::from(i128::from(found as i8) != truth);
        }
    }
    counts
}

/// The exponents of the three sizes of a set.
fn sizes(coordinates: &[i64]) -> [i32; 3] {
    let bits = 64 - coordinates.iter().map(|x| x.unsigned_abs().leading_zeros()).min().expect("not empty");
    [0, -1074, 1023 - i32::try_from(bits).expect("64 at most")]
}

/// Tries a ladder, and an estimate in its place, which has to be found wrong in each size.
fn ladder<const D: usize, const N: usize>(
    coordinates: &[i64],
    lifted: bool,
    ask: fn([[f64; D]; N]) -> Sign,
    estimate: fn([[f64; D]; N]) -> f64,
) {
    for found in every(coordinates, predicament_effort::some_or_all(997, 1), lifted, ask) {
        println!("{N} points of {D} coordinates: {found:?}");
        assert!(found.all > 1000 && found.zeros > 0 && found.wrong == 0, "{found:?}");
    }
    let sign = |points| match estimate(points) {
        x if x > 0.0 => Sign::Positive,
        x if x < 0.0 => Sign::Negative,
        _ => Sign::Zero,
    };
    let estimated = every(coordinates, 997, lifted, sign);
    assert!(estimated.iter().all(|count| count.wrong > 0), "without exact rungs: {estimated:?}");
}

#[test]
fn every_turn_is_right() {
    let coordinates = [0, 1, -1, 3, (1 << 26) + 1, -(1 << 26) - 1, 1 << 53, -(1 << 53), (1 << 53) - 1, 1 << 60];
    ladder(&coordinates, false, raw::orient2d, |points| anywhere::orient2d(points).determinant);
}

#[test]
fn every_side_of_a_plane_is_right() {
    ladder(&[0, 1, -1, (1 << 39) + 1], false, raw::orient3d, |points| anywhere::orient3d(points).determinant);
}

#[test]
fn every_place_in_a_circle_is_right() {
    let coordinates = [0, 1, -1, (1 << 26) + 1, (1 << 27) - 1, 1 << 27];
    ladder(&coordinates, true, raw::incircle, |points| anywhere::incircle(points).determinant);
}

#[test]
fn every_place_in_a_sphere_is_right() {
    ladder(&[0, 1, (1 << 23) - 1], true, raw::insphere, |points| anywhere::insphere(points).determinant);
}
