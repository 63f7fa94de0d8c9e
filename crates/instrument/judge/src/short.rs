//! Determinants of coordinates of few bits, in 128 bits: GMP's calls take longer than such products.
//!
//! # Bounds
//! In units of the lowest bit of all coordinates, let them be below 2^B. A difference is below 2^d with d = B + 1, and
//! the squared length of D differences below D·2^(2d). A determinant of n rows is a sum of n! products of one entry of
//! each column. Any minor of the first columns and any part of its sum is less than that of the whole, because entries
//! are integers: their bounds are at least one. So everything is below
//!
//! * 2^d for one column, which needs d ≤ 126;
//! * 2·2^(2d) for two, which needs d ≤ 62;
//! * 6·2^(3d) < 2^(3 + 3d) for three, which needs d ≤ 41;
//! * 6·2^(2d)·2·2^(2d) < 2^(4 + 4d) for circles, which needs d ≤ 30;
//! * 24·2^(3d)·3·2^(2d) < 2^(7 + 5d) for spheres, which needs d ≤ 24.

use crate::integers::MOST;
use crate::split::split;

/// The number B of bits below which 128 bits hold everything; coordinates themselves have 62 bits at most.
const fn most(dimension: usize, is_lifted: bool) -> u32 {
    match (dimension, is_lifted) {
        (1, false) => 62,
        (2, false) => 61,
        (3, false) => 40,
        (2, true) => 29,
        (3, true) => 23,
        _ => 0,
    }
}

/// The determinant of the differences to the last point, and the exponent of the power of two that scales it, as
/// [`scaled`](super::integers::scaled) finds them; `None` if the coordinates have too many bits.
pub(super) fn scaled<const D: usize, const N: usize>(points: &[[f64; D]; N], lifted: bool) -> Option<(i128, i32)> {
    let mut lowest = i32::MAX;
    let odd = points.map(|point| {
        point.map(|x| {
            let (significand, exponent) = split(x);
            if significand == 0 {
                return (0, 0);
            }
            let zeros = significand.trailing_zeros();
            let exponent = exponent + zeros.cast_signed();
            lowest = lowest.min(exponent);
            (significand >> zeros, exponent)
        })
    });
    let most = most(D, lifted);
    let mut wholes = [[0_i64; D]; N];
    for (at, x) in odd.as_flattened().iter().zip(points.as_flattened()).enumerate() {
        let (&(significand, exponent), x) = x;
        if significand != 0 {
            let shift = exponent.abs_diff(lowest);
            if u64::BITS - significand.leading_zeros() + shift > most {
                return None;
            }
            let magnitude = significand.cast_signed() << shift;
            wholes.as_flattened_mut()[at] = if *x < 0.0 { -magnitude } else { magnitude };
        }
    }
    let columns = D + usize::from(lifted);
    let mut rows = [[0_i128; MOST]; MOST];
    let (last, others) = wholes.split_last()?;
    for (row, point) in rows.iter_mut().zip(others) {
        for axis in 0..D {
            let difference = i128::from(point[axis]) - i128::from(last[axis]);
            row[axis] = difference;
            if lifted {
                row[D] += difference * difference;
            }
        }
    }
    // One factor of the unit per column, and one more for the column of squares.
    let degree = i32::try_from(columns + usize::from(lifted)).ok()?;
    Some((determinant(&rows, columns), if lowest == i32::MAX { 0 } else { lowest * degree }))
}

/// The determinant by Laplace's expansion, column by column, over sets of rows.
fn determinant(rows: &[[i128; MOST]; MOST], size: usize) -> i128 {
    let mut minors = [0_i128; 1 << MOST];
    minors[0] = 1;
    for set in 1_usize..1 << size {
        let column = set.count_ones() as usize - 1;
        let mut above = column;
        for (row, entries) in rows.iter().enumerate().take(size) {
            if set >> row & 1 == 1 {
                let term = entries[column] * minors[set ^ 1 << row];
                minors[set] += if above.is_multiple_of(2) { term } else { -term };
                above += 1;
            }
        }
    }
    minors[(1 << size) - 1]
}

#[cfg(test)]
mod tests {
    use rug::Rational;

    use super::*;

    /// Compares the determinants of points whose coordinates have up to so many bits, most of them at the ends of that
    /// range, with rationals; returns how many had few enough.
    fn agree<const D: usize, const N: usize>(bits: u32, lifted: bool, next: &mut dyn FnMut() -> u64) -> [u32; 2] {
        let mut counts = [0; 2];
        for round in 0..60_u32 {
            let unit = 2.0_f64.powi([0, -900, 700, 5][round as usize % 4]);
            let points = [(); N].map(|()| {
                [(); D].map(|()| {
                    let largest = (1_u64 << bits) - 1;
                    // Doubles have 53 bits: larger numbers end in zeros, and one is the unit.
                    let magnitude = match next() % 8 {
                        0 => 0,
                        1 => 1,
                        2 => next() & largest,
                        _ => largest,
                    };
                    let kept = magnitude & !((1 << bits.saturating_sub(53)) - 1);
                    // Both halves and their sum are exact.
                    let [high, low] = [kept >> 32, kept & 0xffff_ffff].map(|half| u32::try_from(half).map(f64::from));
                    let x = if magnitude == 1 { 1.0 } else { high.unwrap() * 2.0_f64.powi(32) + low.unwrap() };
                    unit * if next().is_multiple_of(2) { x } else { -x }
                })
            });
            let exact = points.map(|point| point.map(crate::rational));
            let row = |point: &[Rational; D]| {
                let mut row: Vec<Rational> = (0..D).map(|i| Rational::from(&point[i] - &exact[N - 1][i])).collect();
                if lifted {
                    row.push(row.iter().map(|x| Rational::from(x.square_ref())).sum());
                }
                row
            };
            let truth = crate::determinant(&exact[..N - 1].iter().map(row).collect::<Vec<_>>());
            let found = scaled(&points, lifted);
            if let Some((value, exponent)) = found {
                assert_eq!(Rational::from(value) << exponent, truth, "{points:?}");
            }
            counts[usize::from(found.is_some())] += 1;
        }
        counts
    }

    #[test]
    fn what_fits_into_128_bits_is_exact() {
        let mut state = 11_u64;
        let mut next = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state >> 30
        };
        let mut counts = [[0; 2]; 5];
        for bits in (2..64).flat_map(|bits| [bits; 2]) {
            let all = [
                agree::<1, 2>(bits, false, &mut next),
                agree::<2, 3>(bits, false, &mut next),
                agree::<3, 4>(bits, false, &mut next),
                agree::<2, 4>(bits, true, &mut next),
                agree::<3, 5>(bits, true, &mut next),
            ];
            counts.iter_mut().zip(all).for_each(|(sum, [no, yes])| *sum = [sum[0] + no, sum[1] + yes]);
        }
        assert!(counts.iter().all(|[no, yes]| *no > 10 && *yes > 1000), "{counts:?}");
    }
}
