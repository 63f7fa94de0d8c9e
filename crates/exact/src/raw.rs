//! Predicates on bare coordinates, without a scene that was prepared.
//!
//! For callers that have points and no scene. What a session knows in advance
//! has to be found out here, query by query: that nothing overflows or
//! underflows, and how large rounding errors can be. Both come from the
//! largest difference of the query along each axis.
//!
//! # The filter
//! The static bound of [`bound`], with the query's own extents for the scene's,
//! is right unless something underflows or overflows. With extents at most
//! 2^200 nothing overflows: 5·200 + 7 ≤ 1023. A product that underflows is off
//! by 2^-1075 at most, instead of by a relative u, and what is multiplied with
//! it later are entries within their extents: for a product of the axes' extents
//! E that bounds a term, the error is at most 2^-1075·E/F with F a product of at
//! least two extents. With *all* extents at least 2^-140, F ≥ 2^-280 (with a
//! lift, ≥ 2^-700), and a hundred such errors are less than 2^-300·E, nothing
//! beside the 2^-50·u·E by which the bound exceeds what roundings need.
//!
//! Coordinates must be finite; others make the functions panic.

// Loops over indices stay in registers, where `map` on arrays goes through memory.
#![allow(clippy::needless_range_loop)]

use predicament_arithmetic::{bound, power_of_two};
use predicament_predicates::Sign;

use crate::ladder::alone;
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};

/// The sign of (a − c) × (b − c): positive if a, b, c turn counterclockwise.
#[inline]
#[must_use]
pub fn orient2d(points: [[f64; 2]; 3]) -> Sign {
    answer::<Orient2d, 2, 3>(points, orient2d_bound)
}

/// The sign of det(a − d, b − d, c − d): positive if d lies below the plane of a, b, c.
#[inline]
#[must_use]
pub fn orient3d(points: [[f64; 3]; 4]) -> Sign {
    answer::<Orient3d, 3, 4>(points, orient3d_bound)
}

/// Positive if d is in the circle of a counterclockwise a, b, c.
#[inline]
#[must_use]
pub fn incircle(points: [[f64; 2]; 4]) -> Sign {
    answer::<Incircle, 2, 4>(points, incircle_bound)
}

/// Positive if e is in the sphere of a positively oriented a, b, c, d.
#[inline]
#[must_use]
pub fn insphere(points: [[f64; 3]; 5]) -> Sign {
    answer::<Insphere, 3, 5>(points, insphere_bound)
}

// The bounds of `predicament_arithmetic::bound`, but for roundings.

#[inline(always)]
fn orient2d_bound([x, y]: [f64; 2]) -> f64 {
    bound::ORIENT2D * 2.0 * x * y
}

#[inline(always)]
fn orient3d_bound([x, y, z]: [f64; 3]) -> f64 {
    bound::ORIENT3D * 6.0 * x * y * z
}

#[inline(always)]
fn incircle_bound([x, y]: [f64; 2]) -> f64 {
    bound::INCIRCLE * 6.0 * (x * y) * (x * x + y * y)
}

#[inline(always)]
fn insphere_bound([x, y, z]: [f64; 3]) -> f64 {
    bound::INSPHERE * 24.0 * (x * y * z) * (x * x + y * y + z * z)
}

/// Pays for the roundings of extents and of the bound, 13 of at most u each; the rest is for underflow.
const MARGIN: f64 = 1.0 + 16.0 * f64::EPSILON;
/// The extents for which the filter is proved.
const LOWEST: f64 = power_of_two(-140);
const HIGHEST: f64 = power_of_two(200);

#[inline(always)]
fn answer<P: Predicate<D, N>, const D: usize, const N: usize>(
    points: [[f64; D]; N],
    bound: impl Fn([f64; D]) -> f64,
) -> Sign {
    let mut extent = [0.0; D];
    for row in 0..N - 1 {
        for axis in 0..D {
            let size = (points[row][axis] - points[N - 1][axis]).abs();
            extent[axis] = if size > extent[axis] { size } else { extent[axis] };
        }
    }
    let is_safe = extent.iter().fold(true, |safe, &x| safe & (LOWEST..=HIGHEST).contains(&x));
    let bound = if is_safe { bound(extent) * MARGIN } else { f64::NAN };
    P::estimate(points).above(bound).unwrap_or_else(|| climb::<P, D, N>(points))
}

#[cold]
#[inline(never)]
fn climb<P: Predicate<D, N>, const D: usize, const N: usize>(points: [[f64; D]; N]) -> Sign {
    alone::<P, D, N>(&points).0
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn extent() -> impl Strategy<Value = f64> {
        prop_oneof![LOWEST..2.0 * LOWEST, 1.0..2.0, HIGHEST / 2.0..HIGHEST, Just(LOWEST), Just(HIGHEST)]
    }

    /// No less than the bound that the proofs are about, and hardly more.
    fn hold(mine: f64, proved: f64) -> Result<(), TestCaseError> {
        let mine = mine * MARGIN;
        // (The other one is rounded up in each operation, as far as it goes.)
        let rounded_up = 1.0 + 8.0 * f64::EPSILON;
        prop_assert!(mine.is_finite() && mine * rounded_up >= proved && mine <= proved * (1.0 + 1e-14));
        prop_assert!(mine * 0.98 < proved, "two percent less are seen");
        Ok(())
    }

    proptest! {
        #[test]
        fn bounds_are_those_of_static_filters(x in extent(), y in extent(), z in extent()) {
            hold(orient2d_bound([x, y]), bound::static_orient2d([x, y]))?;
            hold(orient3d_bound([x, y, z]), bound::static_orient3d([x, y, z]))?;
            hold(incircle_bound([x, y]), bound::static_incircle([x, y]))?;
            hold(insphere_bound([x, y, z]), bound::static_insphere([x, y, z]))?;
        }
    }
}
