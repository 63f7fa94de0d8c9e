//! Vectors as arrays, with a fixed order of every sum, because an error bound holds for one order of evaluation.
//!
//! Sums run from the first coordinate to the last, without a zero to start from.

use crate::{Ring, Root};

/// The difference a − b.
#[inline(always)]
#[must_use]
pub fn minus<N: Ring, const D: usize>(a: &[N; D], b: &[N; D]) -> [N; D] {
    std::array::from_fn(|i| a[i].clone() - b[i].clone())
}

/// Every coordinate times `factor`.
#[inline]
#[must_use]
pub fn scaled<N: Ring, const D: usize>(a: &[N; D], factor: &N) -> [N; D] {
    std::array::from_fn(|i| a[i].clone() * factor.clone())
}

/// The negated vector −a.
#[inline]
#[must_use]
pub fn negated<N: Ring, const D: usize>(a: &[N; D]) -> [N; D] {
    std::array::from_fn(|i| -a[i].clone())
}

/// The dot product a · b = (a₀b₀ + a₁b₁) + a₂b₂.
#[inline(always)]
#[must_use]
pub fn dot<N: Ring, const D: usize>(a: &[N; D], b: &[N; D]) -> N {
    sum(|i| a[i].clone() * b[i].clone(), D)
}

/// The squared norm ‖a‖² = (a₀² + a₁²) + a₂².
#[inline(always)]
#[must_use]
pub fn norm_squared<N: Ring, const D: usize>(a: &[N; D]) -> N {
    sum(|i| a[i].clone().square(), D)
}

/// The norm ‖a‖.
#[inline]
#[must_use]
pub fn norm<N: Root, const D: usize>(a: &[N; D]) -> N {
    norm_squared(a).sqrt()
}

/// The cross product a × b in the plane, a number: a₀b₁ − a₁b₀.
#[inline(always)]
#[must_use]
pub fn perp<N: Ring>(a: &[N; 2], b: &[N; 2]) -> N {
    a[0].clone() * b[1].clone() - a[1].clone() * b[0].clone()
}

/// The cross product a × b in space.
#[inline(always)]
#[must_use]
pub fn cross<N: Ring>(a: &[N; 3], b: &[N; 3]) -> [N; 3] {
    let minor = |i: usize, j: usize| a[i].clone() * b[j].clone() - a[j].clone() * b[i].clone();
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

#[inline(always)]
fn sum<N: Ring>(term: impl Fn(usize) -> N, terms: usize) -> N {
    (1..terms).fold(term(0), |sum, i| sum + term(i))
}
