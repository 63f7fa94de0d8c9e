//! Predicates on bare coordinates: nothing is prepared, nothing is assumed.
//!
//! For callers who have points and no scene. What a session knows in advance
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

use predicament_arithmetic::bound;
use predicament_predicates::Sign;

use crate::ladder::{alone, power};
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};

/// The sign of (a − c) × (b − c): positive if a, b, c turn counterclockwise.
#[inline]
#[must_use]
pub fn orient2d(points: [[f64; 2]; 3]) -> Sign {
    answer::<Orient2d, 2, 3>(points, |[x, y]| bound::ORIENT2D * 2.0 * x * y)
}

/// The sign of det(a − d, b − d, c − d): positive if d lies below the plane of a, b, c.
#[inline]
#[must_use]
pub fn orient3d(points: [[f64; 3]; 4]) -> Sign {
    answer::<Orient3d, 3, 4>(points, |[x, y, z]| bound::ORIENT3D * 6.0 * x * y * z)
}

/// Positive if d is in the circle of a counterclockwise a, b, c.
#[inline]
#[must_use]
pub fn incircle(points: [[f64; 2]; 4]) -> Sign {
    answer::<Incircle, 2, 4>(points, |[x, y]| bound::INCIRCLE * 6.0 * (x * y) * (x * x + y * y))
}

/// Positive if e is in the sphere of a positively oriented a, b, c, d.
#[inline]
#[must_use]
pub fn insphere(points: [[f64; 3]; 5]) -> Sign {
    answer::<Insphere, 3, 5>(points, |[x, y, z]| bound::INSPHERE * 24.0 * (x * y * z) * (x * x + y * y + z * z))
}

/// Pays for the roundings of extents and of the bound, 13 of at most u each; the rest is for underflow.
const MARGIN: f64 = 1.0 + 16.0 * f64::EPSILON;

#[inline(always)]
fn answer<P: Predicate<D, N>, const D: usize, const N: usize>(
    points: [[f64; D]; N],
    bound: impl Fn([f64; D]) -> f64,
) -> Sign {
    const LOWEST: f64 = power(-140);
    const HIGHEST: f64 = power(200);
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
