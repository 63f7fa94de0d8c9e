//! Turns of few bits: which of two products is larger.
//!
//! Where differences are doubles, the turn of three points is the sign of
//! l − r for two products of doubles, each of which has 106 bits and can be had
//! exactly, whatever its exponent.

use predicament_arithmetic::{Parts, exact_differences};
use predicament_predicates::Sign;

/// The turn of three points, if their differences are doubles.
#[inline(always)]
pub(crate) fn orient2d(points: [[f64; 2]; 3]) -> Option<Sign> {
    let [[ax, ay], [bx, by], _] = exact_differences(points)?;
    let [left, right] = [Product::new(ax, by)?, Product::new(ay, bx)?];
    Some(left.compare(right))
}

/// significand · 2^exponent, with the sign of the significand.
#[derive(Clone, Copy)]
struct Product {
    significand: i128,
    exponent: i32,
}

/// The highest bit of a normal double's significand.
const HIDDEN: u64 = 1 << 52;

impl Product {
    /// The exact product of two doubles that are zero or normal.
    #[inline(always)]
    fn new(x: f64, y: f64) -> Option<Product> {
        // (Infinite differences are not exact, so they don't come here.)
        let (x, y) = (Parts::of(x)?, Parts::of(y)?);
        if (x.significand == 0) | (y.significand == 0) {
            return Some(Product { significand: 0, exponent: 0 });
        }
        if (x.significand < HIDDEN) | (y.significand < HIDDEN) {
            return None;
        }
        let magnitude = (u128::from(x.significand) * u128::from(y.significand)).cast_signed();
        let significand = if x.negative == y.negative { magnitude } else { -magnitude };
        Some(Product { significand, exponent: x.exponent + y.exponent })
    }

    /// The sign of self − other.
    #[inline(always)]
    fn compare(self, other: Product) -> Sign {
        // Significands have 105 or 106 bits: from 2^3 on the larger exponent decides, and shifts
        // by 3 keep that so.
        let shift = |mine: i32, theirs: i32| (mine - theirs).clamp(0, 3);
        let left = self.significand << shift(self.exponent, other.exponent);
        let right = other.significand << shift(other.exponent, self.exponent);
        Sign::from(left.cmp(&right))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::rational;

    fn double() -> impl Strategy<Value = f64> {
        prop_oneof![
            any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite()),
            (-9..9_i32).prop_map(f64::from),
            (0..3_u64).prop_map(|ulps| f64::from_bits(0.1_f64.to_bits() + ulps)),
            Just(-0.0),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(20_000)))]

        #[test]
        fn an_answer_is_a_right_answer(p in prop::array::uniform3(prop::array::uniform2(double()))) {
            let truth = rational::orient2d(p[0], p[1], p[2]).sign();
            prop_assert!(orient2d(p).is_none_or(|sign| sign == truth));
        }
    }

    #[test]
    fn what_is_answered_and_what_is_not() {
        let tie = [[0.1, 0.1], [0.3, 0.3], [0.2, 0.2]];
        assert_eq!(orient2d(tie), Some(Sign::Zero));
        assert_eq!(orient2d([[1e200, 1e-200], [2e200, 2e-200], [0.0, 0.0]]), Some(Sign::Zero), "no common unit");
        assert_eq!(orient2d([[5e-324, 1.0], [1.0, 1.0], [0.0, 0.0]]), None, "a subnormal difference");
        assert_eq!(orient2d([[f64::MAX, 1.0], [1.0, 1.0], [-f64::MAX, 0.0]]), None, "an infinite difference");
    }
}
