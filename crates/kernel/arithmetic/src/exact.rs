//! Doubles as rationals, and points over one common denominator.

use rug::{Integer, Rational};

use crate::{ExponentRange, Parts};

/// The value of a double as a rational; `None` for NaN and infinity.
#[must_use]
pub fn rational(x: f64) -> Option<Rational> {
    Rational::from_f64(x)
}

/// Points over one common denominator: the integers x·2^−`exponent`.
///
/// The scaling does not change signs of homogeneous polynomials, and integers need no greatest common divisors at every
/// step, as rationals do.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Scaled<const D: usize, const N: usize> {
    /// The integers, point after point.
    pub integers: [[Integer; D]; N],
    /// The exponent of the common power of two: value = integer · 2^`exponent`.
    pub exponent: i32,
}

impl<const D: usize, const N: usize> Scaled<D, N> {
    /// The points over their largest common power of two; `None` if a value is not finite.
    #[must_use]
    pub fn new(points: [[f64; D]; N]) -> Option<Scaled<D, N>> {
        if points.as_flattened().iter().any(|x| !x.is_finite()) {
            return None;
        }
        let exponent = ExponentRange::of(points.as_flattened()).map_or(0, |range| range.lowest);
        Some(Scaled { integers: points.map(|point| point.map(|x| multiple(x, exponent))), exponent })
    }
}

/// The integer x·2^−`exponent`, for an x that is a multiple of 2^`exponent`.
fn multiple(x: f64, exponent: i32) -> Integer {
    let Parts { negative, significand, exponent: own } = Parts::of_any(x);
    // A shift to the right drops zeros only: x has no bit below 2^exponent.
    let magnitude = Integer::from(significand) << (own - exponent);
    if negative { -magnitude } else { magnitude }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn what_is_not_finite_is_refused() {
        assert_eq!(rational(f64::NAN), None);
        assert_eq!(Scaled::new([[1.0, f64::INFINITY]]), None);
        assert_eq!(Scaled::new([[f64::NAN]]), None);
    }

    #[test]
    fn known_values() {
        let scaled = Scaled::new([[0.75], [-0.0], [-8.0]]).unwrap();
        assert_eq!(scaled.exponent, -2);
        assert_eq!(scaled.integers, [[3], [0], [-32]].map(|point| point.map(Integer::from)));
        assert_eq!(Scaled::new([[0.0]]).unwrap().integers, [[Integer::new()]]);
    }

    proptest! {
        /// Compares with rug's own conversion.
        #[test]
        fn scaled_integers_are_the_values(bits in any::<[u64; 3]>()) {
            let values = bits.map(f64::from_bits);
            prop_assume!(values.iter().all(|x| x.is_finite()));
            let scaled = Scaled::new([values]).unwrap();
            for (value, integer) in values.iter().zip(&scaled.integers[0]) {
                prop_assert_eq!(Rational::from(integer) << scaled.exponent, rational(*value).unwrap());
            }
            let odd = scaled.integers[0].iter().any(|i| i.is_odd());
            prop_assert!(odd || values.iter().all(|&x| x == 0.0), "the power of two is the largest");
        }
    }
}
