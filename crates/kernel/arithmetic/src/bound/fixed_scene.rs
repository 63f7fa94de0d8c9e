//! Static filters: one bound for all queries of a scene.
//!
//! Differences of coordinates are at most the scene's extent along their axis. So the permanent of any query is at most
//! the permanent of a query made of extents. The sum of its terms' magnitudes is 2XY for orient2d, 6XYZ for orient3d,
//! 3·(X² + Y²)·2XY for incircle, 4·(X² + Y² + Z²)·6XYZ for insphere. Queries between points at opposite corners of the
//! scene's box come as close to that as doubles allow.
//!
//! Let B be the constant of the semi-static filter, and M the largest permanent, P ≤ M. Then **d has the sign of D if
//! |d| ≥ B·M** by the proof in [`bound`](super). The factor (1 − u)^−(m + 1), which that proof needs for roundings of
//! the permanent, covers here extents that were rounded to nearest: each of them is too small by a factor of 1 − u at
//! worst.
//!
//! The products are rounded up in every case. The double above a product rounded to nearest is not below the product,
//! also if that is subnormal. Overflow gives infinity, with which no finite determinant is certain. An extent of zero
//! makes every determinant an exact zero, and a bound of zero then says so.

use super::{INCIRCLE, INSPHERE, ORIENT2D, ORIENT3D};

/// The magnitude from which on any orient2d of the scene has the right sign.
///
/// `extent` is the largest difference of coordinates along each axis, as floating point finds it (largest minus
/// smallest, rounded to nearest) or larger. The result's unit is the square of the coordinates' unit. As for all
/// filters, the bound assumes that nothing underflows or overflows in the determinant itself. A bound that overflows is
/// infinite, or NaN if an extent of zero follows: then nothing is certain.
#[must_use]
pub fn static_orient2d([x, y]: [f64; 2]) -> f64 {
    product([ORIENT2D, 2.0, x, y])
}

/// The magnitude from which on any orient3d of the scene has the right sign; see [`static_orient2d`].
#[must_use]
pub fn static_orient3d([x, y, z]: [f64; 3]) -> f64 {
    product([ORIENT3D, 6.0, x, y, z])
}

/// The magnitude from which on any incircle of the scene has the right sign; see [`static_orient2d`].
#[must_use]
pub fn static_incircle([x, y]: [f64; 2]) -> f64 {
    product([INCIRCLE, 6.0, x, y, lift([x, y])])
}

/// The magnitude from which on any insphere of the scene has the right sign; see [`static_orient2d`].
#[must_use]
pub fn static_insphere([x, y, z]: [f64; 3]) -> f64 {
    product([INSPHERE, 24.0, x, y, z, lift([x, y, z])])
}

/// A squared diagonal, rounded up.
fn lift<const D: usize>(extent: [f64; D]) -> f64 {
    extent.into_iter().map(|x| product([x, x])).fold(0.0, |sum, square| up(sum + square, sum == 0.0))
}

/// A product of nonnegative numbers, rounded up; zero only if a factor is zero.
fn product<const N: usize>(factors: [f64; N]) -> f64 {
    // Large factors first could overflow, and small factors first underflow, where the whole product does neither. Both
    // only cost answers, and for a scene with such extents no plan allows a filter.
    factors.into_iter().reduce(|x, y| up(x * y, x == 0.0 || y == 0.0)).unwrap_or(1.0)
}

/// The double above a result rounded to nearest, unless the result is known to be exact.
fn up(rounded: f64, exact: bool) -> f64 {
    if exact { rounded } else { rounded.next_up() }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use rug::Rational;

    use super::*;
    use crate::{bound::requirement::REQUIREMENTS, rational};

    /// The bounds of all four predicates, and the exact values that they must exceed.
    fn all([x, y, z]: [f64; 3]) -> [(f64, Rational); 4] {
        let exact = [x, y, z].map(|x| rational(x).unwrap());
        let volume = |axes: &[Rational]| axes.iter().fold(Rational::from(1), |v, x| v * x);
        let diagonal = |axes: &[Rational]| axes.iter().fold(Rational::new(), |s, x| s + Rational::from(x * x));
        let (two, three) = (&exact[..2], &exact[..]);
        let [orient2d, orient3d, incircle, insphere] = REQUIREMENTS.map(|requirement| requirement.fixed_scene());
        [
            (static_orient2d([x, y]), orient2d * 2 * volume(two)),
            (static_orient3d([x, y, z]), orient3d * 6 * volume(three)),
            (static_incircle([x, y]), incircle * 6 * volume(two) * diagonal(two)),
            (static_insphere([x, y, z]), insphere * 24 * volume(three) * diagonal(three)),
        ]
    }

    proptest! {
        #[test]
        fn bounds_are_rounded_up_and_not_by_much(
            extent in prop::array::uniform3(1.0..2f64), exponent in prop::array::uniform3(-60..60i32)
        ) {
            let extent: [f64; 3] = std::array::from_fn(|i| extent[i] * 2f64.powi(exponent[i]));
            for (bound, least) in all(extent) {
                let bound = rational(bound).unwrap();
                prop_assert!(bound > least);
                prop_assert!(bound < least * Rational::from((1_000_000_000_001_u64, 1_000_000_000_000_u64)));
            }
        }

        /// Each sum is rounded up itself, and does not rely on the slack of the squares.
        ///
        /// A large square just below a power of two has half of the unit of its sum with a small square.
        #[test]
        fn squared_diagonals_are_rounded_up(small in 0.08..0.1f64, large in 1.9985..2f64) {
            let exact = [small, large].map(|x| rational(x).unwrap().square());
            let least: Rational = exact.iter().sum();
            let found = rational(lift([small, large])).unwrap();
            // In units of epsilon: 1.5 times 2 of the large square, 4 of the sum, and the rest of the small one.
            prop_assert!(found > least && found < least + rational(10.0 * f64::EPSILON).unwrap());
        }

        /// Arbitrary extents: values too small or too large for a double are rounded up as well.
        #[test]
        fn bounds_are_rounded_up_everywhere(extent in prop::array::uniform3(0..=f64::MAX.to_bits())) {
            for (bound, least) in all(extent.map(f64::from_bits)) {
                prop_assert!(rational(bound).is_none_or(|bound| bound > least || (bound == 0 && least == 0)));
                prop_assert!(!bound.is_nan());
            }
        }
    }

    #[test]
    fn scenes_without_extent_have_certain_zeros_only() {
        for (bound, _) in all([0.0, 1e-200, 3.0]) {
            assert_eq!(bound, 0.0);
        }
        assert_eq!(static_orient2d([5e-324, 5e-324]), 5e-324);
        assert_eq!(static_insphere([f64::MAX, 1.0, 1.0]), f64::INFINITY);
    }

    #[test]
    fn two_percent_less_is_not_enough() {
        for (bound, least) in all([1.0, 3.0, 0.1]) {
            assert!(rational(bound * 0.98).unwrap() < least);
        }
    }
}
