//! Fast signs of determinants, for millions of queries: rationals over one common denominator.
//!
//! The coordinates of a query are multiples of one power of two. In units of that power they are integers, the
//! determinant is an integer, and fractions never need reducing. Rationals spend nine tenths of their time on that
//! reduction. Coordinates of few bits need no more than 128 bits (`short.rs`).

use std::borrow::Cow;
use std::cell::RefCell;

use predicament_predicates::{Axis, Sign};
use rug::ops::NegAssign;
use rug::{Assign, Integer};

use crate::row::Row;
use crate::short;
use crate::split::split;

/// The maximum number of rows of a determinant: spheres have four, of three differences and a lift.
pub(super) const MOST: usize = 4;

/// The integers of a computation, kept by each thread: to allocate them takes longer than to multiply.
#[derive(Default)]
struct Scratch {
    /// The coordinates of five points.
    points: [[Integer; 3]; MOST + 1],
    rows: [[Integer; MOST]; MOST],
    minors: [Integer; 1 << MOST],
}

thread_local! {
    static SCRATCH: RefCell<Scratch> = RefCell::default();
}

/// Calls a function with the determinant of the differences to the last point: an integer and the exponent of the power
/// of two that scales it. If `lifted`, the squared lengths of the differences are the last column.
pub(super) fn scaled<const D: usize, const N: usize, R>(
    points: [[f64; D]; N],
    lifted: bool,
    then: impl FnOnce(&Integer, i32) -> R,
) -> R {
    let columns = D + usize::from(lifted);
    assert!(columns == N - 1 && columns <= MOST, "as many rows as columns, and no more than there is room for");
    if let Some((determinant, exponent)) = short::scaled(&points, lifted) {
        return SCRATCH.with_borrow_mut(|Scratch { minors, .. }| {
            minors[0].assign(determinant);
            then(&minors[0], exponent)
        });
    }
    let lowest = points.as_flattened().iter().filter(|&&x| x != 0.0).map(|&x| split(x).1).min().unwrap_or(0);
    // One factor of the unit per column, and one more for the column of squares.
    let degree = i32::try_from(columns + usize::from(lifted)).expect("five at most");
    SCRATCH.with_borrow_mut(|Scratch { points: wholes, rows, minors }| {
        for (whole, point) in wholes.iter_mut().zip(&points) {
            whole.iter_mut().zip(point).for_each(|(whole, &x)| assign(whole, x, lowest));
        }
        let (others, last) = wholes[..N].split_at(N - 1);
        for (row, point) in rows.iter_mut().zip(others) {
            row[D..columns].iter_mut().for_each(|lift| lift.assign(0));
            for axis in 0..D {
                row[axis].assign(&point[axis] - &last[0][axis]);
                if lifted {
                    let (differences, lift) = row.split_at_mut(D);
                    lift[0] += &differences[axis] * &differences[axis];
                }
            }
        }
        then(determinant(rows, columns, minors), lowest * degree)
    })
}

/// True if |integer|·2^exponent is at most `limit`.
///
/// # Panics
/// If `limit` is not finite.
pub(super) fn is_at_most(integer: &Integer, exponent: i32, limit: f64) -> bool {
    let (significand, of_limit) = split(limit);
    if limit < 0.0 {
        return false;
    }
    // Both sides in units of the smaller power of two.
    let [left, right] = [exponent, of_limit].map(|own| (own - exponent.min(of_limit)).unsigned_abs());
    Integer::from(integer.abs_ref()) << left <= Integer::from(significand) << right
}

/// The sign of the same determinant, along these axes, of points that each have one denominator. Each row is multiplied
/// by a positive weight, its denominator.
pub(super) fn sign_of_rows(points: &[Cow<'_, Row>], axes: &[Axis], lifted: bool) -> Sign {
    let (last, others) = points.split_last().expect("no predicate takes no vertex");
    let columns = axes.len() + usize::from(lifted);
    assert!(columns == others.len() && columns <= MOST, "as many rows as columns, and no more than there is room for");
    let mut rows: [[Integer; MOST]; MOST] = Default::default();
    for (row, point) in rows.iter_mut().zip(others) {
        for (entry, axis) in row.iter_mut().zip(axes) {
            let axis = axis.index();
            *entry = Integer::from(&point.coordinates[axis] * &last.weight);
            *entry -= &last.coordinates[axis] * &point.weight;
        }
        if lifted {
            let weight = Integer::from(&point.weight * &last.weight);
            let (differences, lift) = row.split_at_mut(axes.len());
            for difference in differences {
                lift[0] += &*difference * &*difference;
                *difference *= &weight;
            }
        }
    }
    determinant(&rows, columns, &mut Default::default()).cmp0().into()
}

/// The coordinates of a point as integers, and the power of two that divides them.
pub(super) fn over_one_denominator(point: &[f64]) -> (Vec<Integer>, Integer) {
    let lowest = point.iter().filter(|&&x| x != 0.0).map(|&x| split(x).1).min().unwrap_or(0).min(0);
    (point.iter().map(|&x| integer(x, lowest)).collect(), Integer::from(1) << lowest.unsigned_abs())
}

/// The determinant by Laplace's expansion, column by column: the minor of each set of k rows in the first k columns is
/// computed from the minors of the sets with one row less.
fn determinant<'m>(rows: &[[Integer; MOST]; MOST], size: usize, minors: &'m mut [Integer; 1 << MOST]) -> &'m Integer {
    minors[0].assign(1);
    for set in 1_usize..1 << size {
        let column = set.count_ones() as usize - 1;
        let (smaller, larger) = minors.split_at_mut(set);
        let minor = &mut larger[0];
        minor.assign(0);
        for (above, row) in (0..size).filter(|row| set >> row & 1 == 1).enumerate() {
            let term = &rows[row][column] * &smaller[set ^ 1 << row];
            if (above + column).is_multiple_of(2) {
                *minor += term;
            } else {
                *minor -= term;
            }
        }
    }
    &minors[(1 << size) - 1]
}

/// x / 2^`lowest`, which must be an integer.
fn integer(x: f64, lowest: i32) -> Integer {
    let mut whole = Integer::new();
    assign(&mut whole, x, lowest);
    whole
}

/// Assigns x / 2^`lowest`, which must be an integer.
fn assign(whole: &mut Integer, x: f64, lowest: i32) {
    if x == 0.0 {
        whole.assign(0);
        return;
    }
    let (significand, exponent) = split(x);
    whole.assign(significand);
    *whole <<= u32::try_from(exponent - lowest).expect("nothing is lower than the lowest");
    if x < 0.0 {
        whole.neg_assign();
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use rug::Rational;

    use super::*;

    /// Asserts that `split` gives back the double with these bits.
    fn splits(bits: u64) {
        let x = f64::from_bits(bits);
        if let Some(truth) = Rational::from_f64(x) {
            let (significand, exponent) = split(x);
            assert!(significand < 1 << 53 && exponent >= -1074, "{x:e}");
            assert_eq!(Rational::from(significand) << exponent, truth.abs(), "{x:e}");
        } else {
            assert!(std::panic::catch_unwind(|| split(x)).is_err(), "{x} is refused");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(5000))]

        #[test]
        fn doubles_are_split_exactly(bits: u64, field in prop_oneof![0..3_u64, 0x7fd..0x7ff_u64], negative: bool) {
            prop_assume!(f64::from_bits(bits).is_finite());
            splits(bits);
            splits(u64::from(negative) << 63 | field << 52 | bits & ((1 << 52) - 1));
        }
    }

    #[test]
    fn the_ends_of_the_range() {
        for x in [0.0, -0.0, 5e-324, f64::MIN_POSITIVE, f64::MIN_POSITIVE.next_down(), f64::MAX, f64::MIN] {
            splits(x.to_bits());
        }
        for x in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            splits(x.to_bits());
        }
    }
}
