//! The paper's Algorithms 2 to 5 and 7 to 12 (1 and 6 make the tolerances).
//!
//! Each takes points whose coordinate differences are at most the tolerances' L, and may assume the hierarchy's
//! precondition: *no sub-pair is registered*. That is step 2 of each printed algorithm; here the caller checks it.
//! `None` means that the pair is not registered.
//!
//! NaN never registers anything: all tests are written as conditions that must hold, not as conditions that must not.
//!
//! * [`plane`]: pairs in 2D.
//! * [`space`]: pairs in 3D.
//! * [`as_printed`]: Algorithms 3 and 8 with the paper's sign error.

// NaN must not pass, so a test is negated rather than reversed.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

pub mod as_printed;
pub mod plane;
pub mod space;

use predicament_predicates::Band;

use crate::Float;

/// The value T as the algorithm computed it: widened to a double and back it is the same.
#[inline]
fn width<F: Float>(band: Band) -> F {
    F::nearest(band.width)
}

/// Returns true if all values are beyond the tolerance and have the same sign.
#[inline]
fn agree<F: Float, const N: usize>(values: [F; N], tolerance: F) -> bool {
    let first = is_positive(values[0]);
    values.into_iter().all(|value| value.abs() > tolerance && is_positive(value) == first)
}

/// Returns true if both values are beyond the tolerance and their signs differ.
#[inline]
fn differ<F: Float>(values: [F; 2], tolerance: F) -> bool {
    values.into_iter().all(|value| value.abs() > tolerance) && is_positive(values[0]) != is_positive(values[1])
}

#[inline]
fn is_positive<F: Float>(value: F) -> bool {
    value > F::ZERO
}

/// Each value over the sum of all, added from the first to the last.
#[inline]
fn parts<F: Float, const N: usize>(values: [F; N]) -> [F; N] {
    let sum = values.into_iter().skip(1).fold(values[0], |sum, value| sum + value);
    values.map(|value| value / sum)
}

/// The position of the sign change, as the fraction of the way from the first value's place to the second's.
#[inline]
fn crossing<F: Float>([from, to]: [F; 2]) -> F {
    from / (from - to)
}

/// The last steps of Algorithms 3 and 8: â and ā must not be negative, and the weight is â/m.
#[inline]
fn fraction<F: Float, const D: usize>(u: &[F; D], w: &[F; D], m: F) -> Option<F> {
    let [a_hat, a_bar] = crate::quantities::along(u, w, &m);
    (a_hat >= F::ZERO && a_bar >= F::ZERO).then(|| a_hat / m)
}
