//! The paper's Algorithms 2 to 5 and 7 to 12 (1 and 6 make the tolerances).
//!
//! Each takes points none of whose coordinate differences exceeds the
//! tolerances' L, and may assume what the hierarchy gives it: *no sub-pair is
//! registered*. That is step 2 of each printed algorithm and the caller's
//! business. None means that the pair is not registered.
//!
//! A value that is not a number never registers anything: all tests are
//! written as what has to hold, not as what must not.
//!
//! * [`plane`]: pairs in 2D.
//! * [`space`]: pairs in 3D.
//! * [`as_printed`]: Algorithms 3 and 8 with the paper's sign error.

// What is not a number must not pass, so a test is negated rather than turned round.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

pub mod as_printed;
pub mod plane;
pub mod space;

use predicament_predicates::Band;

use crate::Float;

/// T as the algorithm computed it: widened to a double and back it is the same.
#[inline]
fn width<F: Float>(band: Band) -> F {
    F::nearest(band.width)
}

/// All are beyond the tolerance and have the same sign.
#[inline]
fn agree<F: Float, const N: usize>(values: [F; N], tolerance: F) -> bool {
    let first = is_positive(values[0]);
    values.into_iter().all(|value| value.abs() > tolerance && is_positive(value) == first)
}

/// Both are beyond the tolerance and their signs differ.
#[inline]
fn differ<F: Float>(values: [F; 2], tolerance: F) -> bool {
    values.into_iter().all(|value| value.abs() > tolerance) && is_positive(values[0]) != is_positive(values[1])
}

#[inline]
fn is_positive<F: Float>(value: F) -> bool {
    value > F::ZERO
}

/// Each over the sum of all, which is added up from the first to the last.
#[inline]
fn parts<F: Float, const N: usize>(values: [F; N]) -> [F; N] {
    let sum = values.into_iter().skip(1).fold(values[0], |sum, value| sum + value);
    values.map(|value| value / sum)
}

/// Where the sign changes, as the fraction of the way from the first value's place to the second's.
#[inline]
fn crossing<F: Float>([from, to]: [F; 2]) -> F {
    from / (from - to)
}

/// The last steps of Algorithms 3 and 8: â and ā are not negative, and the weight is â/m.
#[inline]
fn fraction<F: Float, const D: usize>(u: &[F; D], w: &[F; D], m: F) -> Option<F> {
    let [a_hat, a_bar] = crate::quantities::along(u, w, &m);
    (a_hat >= F::ZERO && a_bar >= F::ZERO).then(|| a_hat / m)
}
