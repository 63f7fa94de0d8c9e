//! The predicates as determinants of homogeneous rows, exactly.
//!
//! A point is a row (x, y, w) or (x, y, z, w) with w > 0; an input vertex has w = 1. The rows' determinant is that of
//! the points times all the w: it has the sign of the predicate, and no division is needed.
//!
//! If one of four vertices is an input vertex, subtracting its row makes three rows of differences, and most of the
//! numbers short.
//!
//! # Capacity
//! Let the entries of row i be multiples of 2^(64·l_i) and less than 2^(64·t_i): it spans t_i − l_i limbs. A
//! determinant of up to four rows sums products of one entry of each, at most 24, in two steps of [`Number::sum`]:
//! seven bits for rounding the number of terms up to powers of two and for the signs fit one limb more than all rows
//! span. Differences from a pivot row span as much as both rows, and take a bit each. Minors need less, as each row
//! spans at least one limb. Rows that input vertices define always fit; others may not, and are then [`whole`]
//! integers.

use predicament_arithmetic::dyadic::{
    Number, Space, Take,
    Take::{Minus, Plus},
    Term,
};
use predicament_predicates::Sign;

use super::capacity::LARGEST;
use super::whole;

/// The sign of a/w_a − b/w_b for two rows of a coordinate and a weight.
pub(super) fn compare(rows: &[[Number; 2]; 2]) -> Sign {
    match limbs(rows) {
        needed if needed > LARGEST => whole::sign(rows),
        needed => with_capacity!(needed, CAP => order::<CAP>(rows)),
    }
}

/// The turn of three points of a plane.
pub(super) fn orient2d(rows: &[[Number; 3]; 3]) -> Sign {
    match limbs(rows) {
        needed if needed > LARGEST => whole::sign(rows),
        needed => with_capacity!(needed, CAP => turn::<CAP>(rows)),
    }
}

/// The side of the last point on the plane of the others.
pub(super) fn orient3d(rows: &[[Number; 4]; 4]) -> Sign {
    let Some(pivot) = rows.iter().position(|row| row[3].is_one()) else {
        return match limbs(rows) {
            needed if needed > LARGEST => whole::sign(rows),
            needed => with_capacity!(needed, CAP => side::<CAP>(rows)),
        };
    };
    // A cyclic permutation of four elements is odd.
    let [d, a, b, c] = core::array::from_fn(|i| &rows[(pivot + i) % 4]);
    let needed = span(a) + span(b) + span(c) + 3 * span(d) + 1;
    if needed > LARGEST {
        return whole::sign(rows);
    }
    let sign = with_capacity!(needed, CAP => side_of::<CAP>([a, b, c], d));
    if pivot.is_multiple_of(2) { -sign } else { sign }
}

#[inline(never)] // so that the stack frame has the size of this capacity
fn order<const CAP: usize>([a, b]: &[[Number; 2]; 2]) -> Sign {
    let mut limbs = [0; CAP];
    sign(Number::sum(&mut Space::new(&mut limbs), cross(*a, *b)))
}

#[inline(never)]
fn turn<const CAP: usize>([a, b, c]: &[[Number; 3]; 3]) -> Sign {
    let mut limbs = [[0; CAP]; 4];
    expand(&mut Space::new(limbs.as_flattened_mut()), a, b, c)
}

/// The side by Laplace's expansion: minors of two rows times minors of the other two.
#[inline(never)]
fn side<const CAP: usize>([a, b, c, d]: &[[Number; 4]; 4]) -> Sign {
    // The complement of the k-th pair is the k-th from the end.
    const PAIRS: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
    const TAKES: [Take; 6] = [Plus, Minus, Plus, Plus, Minus, Plus];
    let mut limbs = [[0; CAP]; 13];
    let space = &mut Space::new(limbs.as_flattened_mut());
    let mut terms = [(Number::ZERO, Number::ZERO, Plus); 6];
    for (k, [i, j]) in PAIRS.into_iter().enumerate() {
        terms[k].0 = Number::sum(space, cross([a[i], a[j]], [b[i], b[j]]));
        terms[5 - k].1 = Number::sum(space, cross([c[i], c[j]], [d[i], d[j]]));
        terms[k].2 = TAKES[k];
    }
    sign(Number::sum(space, terms))
}

/// The side relative to a row of weight 1.
///
/// Subtracting it from the others, times their weights, leaves three rows of differences.
#[inline(never)]
fn side_of<const CAP: usize>([a, b, c]: [&[Number; 4]; 3], pivot: &[Number; 4]) -> Sign {
    let mut limbs = [[0; CAP]; 13];
    let space = &mut Space::new(limbs.as_flattened_mut());
    let mut differences = [[Number::ZERO; 3]; 3];
    for (difference, row) in differences.iter_mut().zip([a, b, c]) {
        for (j, difference) in difference.iter_mut().enumerate() {
            *difference = Number::sum(space, [(row[j], Number::ONE, Plus), (pivot[j], row[3], Minus)]);
        }
    }
    let [a, b, c] = &differences;
    expand(space, a, b, c)
}

/// The sign of a 3 × 3 determinant, by four sums.
#[inline(always)]
fn expand<'a>(space: &mut Space<'a>, a: &[Number<'a>; 3], b: &[Number<'a>; 3], c: &[Number<'a>; 3]) -> Sign {
    // Minors are taken of short rows. A cyclic permutation of three elements is even.
    let long = |row: &[Number<'a>; 3]| row.iter().map(|x| x.limbs.len()).max();
    let [a, b, c] = match [long(a), long(b), long(c)] {
        [a_long, b_long, c_long] if b_long > a_long && b_long >= c_long => [b, c, a],
        [a_long, _, c_long] if c_long > a_long => [c, a, b],
        _ => [a, b, c],
    };
    let mut terms = [(Number::ZERO, Number::ZERO, Plus); 3];
    for (k, [i, j]) in [[1, 2], [2, 0], [0, 1]].into_iter().enumerate() {
        terms[k] = (a[k], Number::sum(space, cross([b[i], b[j]], [c[i], c[j]])), Plus);
    }
    sign(Number::sum(space, terms))
}

/// The terms of a minor.
#[inline(always)]
fn cross<'a>(p: [Number<'a>; 2], q: [Number<'a>; 2]) -> [Term<'a>; 2] {
    [(p[0], q[1], Plus), (p[1], q[0], Minus)]
}

#[inline(always)]
fn sign(number: Number) -> Sign {
    Sign::from(number.cmp0())
}

/// The limbs that the determinant of these rows needs.
fn limbs<const N: usize>(rows: &[[Number; N]]) -> usize {
    rows.iter().map(span).sum::<usize>() + 1
}

/// The number of limbs between the lowest and the highest of a row's entries.
#[inline]
fn span<const N: usize>(row: &[Number; N]) -> usize {
    let (mut low, mut top) = (i32::MAX, i32::MIN);
    for entry in row.iter().filter(|entry| !entry.is_zero()) {
        low = low.min(entry.low);
        top = top.max(entry.top());
    }
    // The weight is never zero.
    usize::try_from(top - low).unwrap_or(0)
}

#[cfg(test)]
mod tests;
