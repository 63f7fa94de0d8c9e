//! Signs of determinants by the million: rationals over one common denominator.
//!
//! The coordinates of a query are multiples of one power of two. In units of
//! it they are integers, the determinant is an integer, and no fraction ever has
//! to be reduced: that is where rationals spend nine tenths of their time.

use std::borrow::Cow;

use predicament_predicates::{Axis, Sign};
use rug::Integer;

use crate::points::Row;

/// Rows of a determinant at most: insphere has four, of three differences and a lift.
const MOST: usize = 4;

/// The sign of the determinant of the differences to the last point, with
/// their squared lengths for a last column if `lifted`.
pub(super) fn sign<const D: usize, const N: usize>(points: [[f64; D]; N], lifted: bool) -> Sign {
    let columns = D + usize::from(lifted);
    assert!(columns == N - 1 && columns <= MOST, "as many rows as columns, and no more than there is room for");
    let lowest = points.as_flattened().iter().filter(|&&x| x != 0.0).map(|&x| exponent(x)).min().unwrap_or(0);
    let points = points.map(|point| point.map(|x| integer(x, lowest)));
    let mut rows: [[Integer; MOST]; MOST] = Default::default();
    for (row, point) in rows.iter_mut().zip(&points[..N - 1]) {
        for axis in 0..D {
            let difference = Integer::from(&point[axis] - &points[N - 1][axis]);
            if lifted {
                row[D] += &difference * &difference;
            }
            row[axis] = difference;
        }
    }
    determinant(&rows, columns).cmp0().into()
}

/// The same of points over one denominator each, along these axes. Rows are multiplied by the
/// positive weights that stand below them.
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
    determinant(&rows, columns).cmp0().into()
}

/// The coordinates of a point as integers, and the power of two that they are to be divided by.
pub(super) fn over_one_denominator(point: &[f64]) -> (Vec<Integer>, Integer) {
    let lowest = point.iter().filter(|&&x| x != 0.0).map(|&x| exponent(x)).min().unwrap_or(0).min(0);
    (point.iter().map(|&x| integer(x, lowest)).collect(), Integer::from(1) << lowest.unsigned_abs())
}

/// Laplace's expansion, column by column: of each set of k rows the minor in the
/// first k columns, from those of the sets with one row less.
fn determinant(rows: &[[Integer; MOST]; MOST], size: usize) -> Integer {
    let mut minors: [Integer; 1 << MOST] = Default::default();
    minors[0] = Integer::from(1);
    for set in 1_usize..1 << size {
        let column = set.count_ones() as usize - 1;
        let mut minor = Integer::new();
        for (above, row) in (0..size).filter(|row| set >> row & 1 == 1).enumerate() {
            let term = &rows[row][column] * &minors[set ^ 1 << row];
            if (above + column).is_multiple_of(2) {
                minor += term;
            } else {
                minor -= term;
            }
        }
        minors[set] = minor;
    }
    std::mem::take(&mut minors[(1 << size) - 1])
}

/// The exponent of the unit in the last place of a finite double: at least −1074.
fn exponent(x: f64) -> i32 {
    let biased = i32::try_from(x.to_bits() >> 52 & 0x7ff).expect("11 bits");
    assert!(biased < 0x7ff, "scenes hold finite coordinates only");
    biased.max(1) - 1075
}

/// x / 2^`lowest`, which has to be an integer.
fn integer(x: f64, lowest: i32) -> Integer {
    if x == 0.0 {
        return Integer::new();
    }
    let fraction = x.to_bits() & ((1 << 52) - 1);
    let significand = if x.is_subnormal() { fraction } else { fraction | 1 << 52 };
    let shift = u32::try_from(exponent(x) - lowest).expect("nothing is lower than the lowest");
    let magnitude = Integer::from(significand) << shift;
    if x < 0.0 { -magnitude } else { magnitude }
}
