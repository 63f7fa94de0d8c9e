//! Signs of determinants by the million: rationals over one common denominator.
//!
//! The coordinates of a query are multiples of one power of two. In units of
//! it they are integers, the determinant is an integer, and no fraction ever has
//! to be reduced: that is where rationals spend nine tenths of their time.

use predicament_predicates::Sign;
use rug::Integer;

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
