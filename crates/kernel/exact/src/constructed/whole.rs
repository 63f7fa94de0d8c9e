//! Determinants of rows in integers of any length, for rows that are too long for the stack.

use alloc::{vec, vec::Vec};
use predicament_predicates::Sign;

use predicament_arithmetic::{BigInt, dyadic::Number};

/// A row as integers: times a power of two, which does not change the point.
pub(super) fn integers<const N: usize>(row: &[Number; N]) -> [BigInt; N] {
    let lowest = row.iter().filter(|x| !x.is_zero()).map(|x| x.low).min().unwrap_or(0);
    row.map(|x| {
        let zeros = if x.is_zero() { 0 } else { usize::try_from(x.low - lowest).expect("not below the lowest") };
        let mut limbs = vec![0; zeros];
        limbs.extend_from_slice(x.limbs);
        BigInt::new(x.negative, limbs)
    })
}

/// The sign of the determinant.
#[cold]
#[inline(never)]
pub(super) fn sign<const N: usize>(rows: &[[Number; N]; N]) -> Sign {
    let rows: Vec<[BigInt; N]> = rows.iter().map(integers).collect();
    minor(&rows, 0).cmp0().into()
}

/// The position of the last point relative to the circle of the others.
///
/// Let (x, y) be differences over the common weight w > 0 of both points. A row of the determinant is (x/w, y/w, (x² +
/// y²)/w²); times w² it is (x·w, y·w, x² + y²).
#[cold]
#[inline(never)]
pub(super) fn incircle(points: &[[Number; 3]; 4]) -> Sign {
    let [a, b, c, [x, y, w]] = points.each_ref().map(integers);
    let row = |[px, py, pw]: [BigInt; 3]| {
        let [dx, dy] = [(&px, &x), (&py, &y)].map(|(p, q)| &(p * &w) - &(q * &pw));
        let weight = &pw * &w;
        let square = &(&dx * &dx) + &(&dy * &dy);
        [&dx * &weight, &dy * &weight, square]
    };
    minor(&[row(a), row(b), row(c)], 0).cmp0().into()
}

/// The minor of these rows and the columns from `column` on, by Laplace's expansion.
fn minor<const N: usize>(rows: &[[BigInt; N]], column: usize) -> BigInt {
    if let [row] = rows {
        return row[column].clone();
    }
    let mut sum = BigInt::ZERO;
    for at in 0..rows.len() {
        if rows[at][column].is_zero() {
            continue;
        }
        let term = &minor(&[&rows[..at], &rows[at + 1..]].concat(), column + 1) * &rows[at][column];
        sum = if at.is_multiple_of(2) { &sum + &term } else { &sum - &term };
    }
    sum
}
