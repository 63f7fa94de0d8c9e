//! The semi-static filter: plain floating point and a bound on its error.
//!
//! Each function takes a determinant d and its permanent p from [`estimate`], and answers if |d| ≥ bound·p. With the
//! constant of [`bound`](predicament_arithmetic::bound) that is a proof, *provided that nothing underflows or
//! overflows*: callers hold a [`Plan`](predicament_arithmetic::Plan). With a bound of zero the sign of d is the answer,
//! which is right if all intermediates are exact. With a NaN bound there is no answer. The bound is an argument so that
//! a test can run a filter with a wrong one.

use predicament_predicates::Sign;

use crate::estimate;

/// The turn a, b, c; `None` if rounding may have changed it.
#[inline(always)]
#[must_use]
pub fn orient2d(a: [f64; 2], b: [f64; 2], c: [f64; 2], bound: f64) -> Option<Sign> {
    estimate::orient2d(a, b, c).certain(bound)
}

/// The side of d on the plane of a, b, c; `None` if rounding may have changed it.
#[inline(always)]
#[must_use]
pub fn orient3d(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3], bound: f64) -> Option<Sign> {
    estimate::orient3d(a, b, c, d).certain(bound)
}

/// The position of d relative to the circle of a, b, c; `None` if rounding may have changed it.
#[inline(always)]
#[must_use]
pub fn incircle(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2], bound: f64) -> Option<Sign> {
    estimate::incircle(a, b, c, d).certain(bound)
}

/// The position of e relative to the sphere of a, b, c, d; `None` if rounding may have changed it.
#[inline(always)]
#[must_use]
pub fn insphere(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3], e: [f64; 3], bound: f64) -> Option<Sign> {
    estimate::insphere(a, b, c, d, e).certain(bound)
}
