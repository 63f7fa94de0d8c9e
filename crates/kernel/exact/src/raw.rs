//! Predicates on arrays of points, without a prepared scene.
//!
//! They are for callers that have points and no scene; the root of the crate has the same predicates with one argument
//! for each point. The filter is the one for any finite doubles ([`anywhere`](crate::anywhere)): one comparison, and no
//! branch before it. Queries that it leaves open use integers of one limb if the differences are doubles that span few
//! bits, else dyadic numbers.
//!
//! Coordinates must be finite. A filter never decides about others, so their check costs nothing where it decides.

use core::fmt;

use predicament_arithmetic::Sign;

use crate::alone::alone;
use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};

/// The error of a predicate on points: a coordinate is NaN or infinite.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct NotFinite {
    /// The index of the point among the arguments.
    pub point: usize,
    /// The index of the coordinate.
    pub axis: usize,
    /// The coordinate.
    pub value: f64,
}

impl fmt::Display for NotFinite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let NotFinite { point, axis, value } = self;
        write!(f, "coordinate {axis} of point {point} is {value}; predicates are about finite numbers")
    }
}

impl core::error::Error for NotFinite {}

/// The first coordinate that is not finite, of points that have one.
fn not_finite<const D: usize>(points: &[[f64; D]]) -> NotFinite {
    let at = points.as_flattened().iter().position(|x| !x.is_finite()).unwrap_or(0);
    NotFinite { point: at / D, axis: at % D, value: points[at / D][at % D] }
}

/// Writes a predicate in two forms: the second one returns the error of the first one's panic.
///
/// Open queries are passed on number by number: an array that must be in memory there would be built in memory before
/// the filter, and every query would wait for it. (The same holds for values that a closure captures, if it is not
/// inlined, and for points that a caller picks from a list: that is why filters are always inlined.)
macro_rules! predicate {
    (
        $(#[$doc:meta])*
        $name:ident, $try_name:ident, $predicate:ident<$dimension:literal, $arity:literal>, $([$($x:ident),+]),+
    ) => {
        mod $name {
            use super::*;

            #[cold]
            #[inline(never)]
            #[allow(clippy::too_many_arguments)]
            pub fn climb($($($x: f64),+),+) -> Option<Sign> {
                alone::<$predicate, $dimension, $arity>(&[$([$($x),+]),+]).map(|(sign, _)| sign)
            }

            #[cold]
            #[inline(never)]
            #[allow(clippy::too_many_arguments)]
            pub fn blame($($($x: f64),+),+) -> NotFinite {
                not_finite(&[$([$($x),+]),+])
            }

            #[cold]
            #[inline(never)]
            #[allow(clippy::too_many_arguments)]
            pub fn refuse($($($x: f64),+),+) -> ! {
                panic!("{}", blame($($($x),+),+))
            }
        }

        $(#[$doc])*
        ///
        /// # Panics
        /// If a coordinate is NaN or infinite.
        #[inline(always)]
        #[must_use]
        pub fn $name([$([$($x),+]),+]: [[f64; $dimension]; $arity]) -> Sign {
            match $predicate::anywhere([$([$($x),+]),+]).certain() {
                Some(sign) => sign,
                None => match $name::climb($($($x),+),+) {
                    Some(sign) => sign,
                    None => $name::refuse($($($x),+),+),
                },
            }
        }

        $(#[$doc])*
        ///
        /// # Errors
        /// The first coordinate that is NaN or infinite.
        #[inline(always)]
        pub fn $try_name([$([$($x),+]),+]: [[f64; $dimension]; $arity]) -> Result<Sign, NotFinite> {
            match $predicate::anywhere([$([$($x),+]),+]).certain() {
                Some(sign) => Ok(sign),
                None => match $name::climb($($($x),+),+) {
                    Some(sign) => Ok(sign),
                    None => Err($name::blame($($($x),+),+)),
                },
            }
        }
    };
}

predicate! {
    /// The sign of (a − c) × (b − c): positive if a, b, c turn counterclockwise.
    orient2d, try_orient2d, Orient2d<2, 3>, [ax, ay], [bx, by], [cx, cy]
}
predicate! {
    /// The sign of det(a − d, b − d, c − d): positive if d lies below the plane of a, b, c.
    orient3d, try_orient3d, Orient3d<3, 4>, [ax, ay, az], [bx, by, bz], [cx, cy, cz], [dx, dy, dz]
}
predicate! {
    /// The sign of the circle test: positive if d is in the circle of a counterclockwise a, b, c.
    incircle, try_incircle, Incircle<2, 4>, [ax, ay], [bx, by], [cx, cy], [dx, dy]
}
predicate! {
    /// The sign of the sphere test: positive if e is in the sphere of a positively oriented a, b, c, d.
    insphere, try_insphere, Insphere<3, 5>, [ax, ay, az], [bx, by, bz], [cx, cy, cz], [dx, dy, dz], [ex, ey, ez]
}

/// The sign of any predicate for finite points, for callers that are generic.
#[inline(always)]
pub(crate) fn sign<P: Predicate<D, N>, const D: usize, const N: usize>(points: [[f64; D]; N]) -> Sign {
    #[cold]
    #[inline(never)]
    fn climb<P: Predicate<D, N>, const D: usize, const N: usize>(points: [[f64; D]; N]) -> Sign {
        alone::<P, D, N>(&points).unwrap_or_else(|| panic!("{}", not_finite(&points))).0
    }
    P::anywhere(points).certain().unwrap_or_else(|| climb::<P, D, N>(points))
}
