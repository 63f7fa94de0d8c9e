//! Predicates on points, without a scene: in place of `robust`, `geometry-predicates` and C's `predicates.c`.
//!
//! Points of doubles are at the [root](crate) of the crate. [`f32`], [`i32`] and [`i64`] have the same functions for
//! points of these numbers, whose answers are as exact: the first two are doubles too, and integers of 64 bits are
//! subtracted without rounding.

use predicament_arithmetic::Sign;

use crate::raw::{self, NotFinite};

/// Writes a predicate in both forms.
macro_rules! predicate {
    ($(#[$doc:meta])* $name:ident, $try_name:ident, $dimension:literal, $($point:ident),+) => {
        $(#[$doc])*
        ///
        /// # Panics
        /// If a coordinate is NaN or infinite.
        #[inline(always)]
        #[must_use]
        pub fn $name($($point: impl Into<[f64; $dimension]>),+) -> Sign {
            raw::$name([$($point.into()),+])
        }

        $(#[$doc])*
        ///
        /// # Errors
        /// The first coordinate that is NaN or infinite.
        #[inline(always)]
        pub fn $try_name($($point: impl Into<[f64; $dimension]>),+) -> Result<Sign, NotFinite> {
            raw::$try_name([$($point.into()),+])
        }
    };
}

predicate! {
    /// The sign of (a − c) × (b − c): positive if a, b, c turn counterclockwise, zero if they are collinear.
    orient2d, try_orient2d, 2, a, b, c
}
predicate! {
    /// The sign of det(a − d, b − d, c − d): positive if d is below the plane of a, b, c, which appear counterclockwise
    /// from above; zero if the four points are coplanar.
    orient3d, try_orient3d, 3, a, b, c, d
}
predicate! {
    /// The sign of the circle test: positive if d is in the circle of a counterclockwise a, b, c; zero if it is on it.
    incircle, try_incircle, 2, a, b, c, d
}
predicate! {
    /// The sign of the sphere test: positive if e is in the sphere of a, b, c, d with a positive [`orient3d`]; zero if
    /// it is on it.
    insphere, try_insphere, 3, a, b, c, d, e
}

/// Writes the four predicates for points of another type of numbers.
macro_rules! of_numbers {
    ($number:ident, $answer:ident) => {
        of_numbers! { @one $number, $answer, orient2d, Orient2d, 2, a, b, c }
        of_numbers! { @one $number, $answer, orient3d, Orient3d, 3, a, b, c, d }
        of_numbers! { @one $number, $answer, incircle, Incircle, 2, a, b, c, d }
        of_numbers! { @one $number, $answer, insphere, Insphere, 3, a, b, c, d, e }
    };
    (@one $number:ident, $answer:ident, $name:ident, $predicate:ident, $dimension:literal, $($point:ident),+) => {
        #[doc = concat!("The sign of [`", stringify!($name), "`](crate::", stringify!($name), "), exactly.")]
        #[inline(always)]
        #[must_use]
        pub fn $name($($point: impl Into<[$number; $dimension]>),+) -> Sign {
            $answer::<$predicate, $dimension, _>([$($point.into()),+])
        }
    };
}

/// Predicates on points of single precision.
///
/// Each number is converted to a double without rounding.
pub mod f32 {
    use super::NotFinite;
    use predicament_arithmetic::Sign;

    macro_rules! widened {
        ($name:ident, $try_name:ident, $dimension:literal, $($point:ident),+) => {
            #[doc = concat!("The sign of [`", stringify!($name), "`](crate::", stringify!($name), "), exactly.")]
            ///
            /// # Panics
            /// If a coordinate is NaN or infinite.
            #[inline(always)]
            #[must_use]
            pub fn $name($($point: impl Into<[f32; $dimension]>),+) -> Sign {
                crate::$name($($point.into().map(f64::from)),+)
            }

            #[doc = concat!("The sign of [`", stringify!($name), "`](crate::", stringify!($name), "), exactly.")]
            ///
            /// # Errors
            /// The first coordinate that is NaN or infinite.
            #[inline(always)]
            pub fn $try_name($($point: impl Into<[f32; $dimension]>),+) -> Result<Sign, NotFinite> {
                crate::$try_name($($point.into().map(f64::from)),+)
            }
        };
    }

    widened! { orient2d, try_orient2d, 2, a, b, c }
    widened! { orient3d, try_orient3d, 3, a, b, c, d }
    widened! { incircle, try_incircle, 2, a, b, c, d }
    widened! { insphere, try_insphere, 3, a, b, c, d, e }
}

/// Predicates on points of integers of 32 bits.
///
/// Each number is converted to a double without rounding.
pub mod i32 {
    use predicament_arithmetic::Sign;

    use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};
    use crate::raw;

    #[inline(always)]
    fn answer<P: Predicate<D, N>, const D: usize, const N: usize>(points: [[i32; D]; N]) -> Sign {
        raw::sign::<P, D, N>(points.map(|point| point.map(f64::from)))
    }

    of_numbers! { i32, answer }
}

/// Predicates on points of integers of 64 bits.
///
/// Numbers up to 2^53 in magnitude are converted to doubles without rounding. With others, the differences take 65
/// bits, and determinants of integers of a fixed size decide.
pub mod i64 {
    use predicament_arithmetic::Sign;

    use crate::differences::Rows;
    use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d, Predicate};
    use crate::raw;

    /// The largest magnitude up to which all integers are doubles.
    const DOUBLES: u64 = 1 << f64::MANTISSA_DIGITS;

    #[inline(always)]
    fn answer<P: Predicate<D, N>, const D: usize, const N: usize>(points: [[i64; D]; N]) -> Sign {
        if points.as_flattened().iter().all(|x| x.unsigned_abs() <= DOUBLES) {
            #[allow(clippy::cast_precision_loss)] // at most 2^53
            let doubles = points.map(|point| point.map(|x| x as f64));
            return raw::sign::<P, D, N>(doubles);
        }
        of_differences::<P, D, N>(&points)
    }

    #[inline(never)]
    fn of_differences<P: Predicate<D, N>, const D: usize, const N: usize>(points: &[[i64; D]; N]) -> Sign {
        let rows = Rows::of_integers(points);
        match rows.shortened() {
            Some((rows, bits)) => P::integer(rows, P::DETERMINANT.limbs(bits)),
            // A difference is less than 2^64 in magnitude.
            None => P::wide_integer(rows.whole(), P::DETERMINANT.limbs(64)),
        }
    }

    of_numbers! { i64, answer }
}

#[cfg(test)]
mod tests;
