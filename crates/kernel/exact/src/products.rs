//! Turns whose differences are doubles: the comparison of two products.
//!
//! If the differences are doubles, the turn of three points is the sign of L − R for two products of doubles.
//!
//! **In floating point.** Let l and r be the rounded products, and L = l + e, R = r + f exactly (Dekker 1971, after
//! Veltkamp's splitting). Rounding to nearest is monotone: if l > r, then L > R, since L ≤ R would make l ≤ r. If l =
//! r, the sign is that of e − f. The errors are doubles if factors are below 2⁵⁰⁰ and products are above 2⁻⁹⁰⁰ in
//! magnitude, or zero for a factor of zero: the last bits of two factors multiply to 2⁻¹⁰⁰⁶ or more, every intermediate
//! is a multiple of that, and a subnormal factor is split as any other.
//!
//! **In integers**, for products outside this range: two products of 106 bits each, and their exponents.

use predicament_arithmetic::Sign;
use predicament_arithmetic::{Parts, exact_differences, power_of_two};

/// The turn of three points in floating point, if their differences are doubles and their products in range.
#[inline(always)]
pub(crate) fn turn(points: [[f64; 2]; 3]) -> Option<Sign> {
    const LEAST: f64 = power_of_two(-900);
    const MOST: f64 = power_of_two(500);
    // (Infinite differences are not exact.)
    let [[ax, ay], [bx, by], _] = exact_differences(points)?;
    let (left, right) = (ax * by, ay * bx);
    let zero = |x: f64, y: f64| (x == 0.0) | (y == 0.0);
    let high = (left.abs() > LEAST) | zero(ax, by);
    let low = (right.abs() > LEAST) | zero(ay, bx);
    let small = ax.abs() + ay.abs() + bx.abs() + by.abs() < MOST;
    if !(high & low & small) {
        return None;
    }
    let errors = error(left, ax, by) - error(right, ay, bx);
    let difference = left - right;
    Some(Sign::of(if difference == 0.0 { errors } else { difference }))
}

/// The rounding error of a product.
#[inline(always)]
fn error(product: f64, x: f64, y: f64) -> f64 {
    let ([x, x_rest], [y, y_rest]) = (split(x), split(y));
    x_rest * y_rest - (((product - x * y) - x_rest * y) - x * y_rest)
}

/// A double as the sum of two, of 26 bits each.
#[inline(always)]
fn split(x: f64) -> [f64; 2] {
    const SPLITTER: f64 = power_of_two(27) + 1.0;
    let large = SPLITTER * x;
    let high = large - (large - x);
    [high, x - high]
}

/// The turn of three points in integers, if their differences are doubles.
#[inline(always)]
pub(crate) fn orient2d(points: [[f64; 2]; 3]) -> Option<Sign> {
    let [[ax, ay], [bx, by], _] = exact_differences(points)?;
    let [left, right] = [Product::new(ax, by)?, Product::new(ay, bx)?];
    Some(left.compare(right))
}

/// A product significand · 2^exponent, with the sign in the significand.
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
        // (Infinite differences are not exact, so they are excluded already.)
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
        // Significands have 105 or 106 bits: if exponents differ by 3 or more the larger exponent decides, and shifts
        // by 3 do not change that.
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
            prop_assert!(turn(p).is_none_or(|sign| sign == truth));
        }

        /// Differences p and q, or an ulp beside them, times numbers of few bits.
        ///
        /// The products are equal, or nearly, at all scales.
        #[test]
        fn nearly_equal_products_are_told_apart(
            (x, y) in (1.0..2.0, 1.0..2.0_f64),
            (m, n) in (1..9_i8, 1..9_i8),
            ulps in prop::array::uniform4(-1..=1_i64),
            exponents in prop::array::uniform2(-520..=520_i32),
        ) {
            let [first, second] = exponents.map(power_of_two);
            let beside = |x: f64, ulps: i64| f64::from_bits(x.to_bits().wrapping_add_signed(ulps));
            let (m, n) = (f64::from(m), f64::from(n));
            let [ax, ay] = [beside(m * x, ulps[0]) * first, beside(n * y, ulps[1]) * second];
            let [bx, by] = [beside(m * x, ulps[2]) * second, beside(n * y, ulps[3]) * first];
            let points = [[ax, ay], [bx, by], [0.0, 0.0]];
            let sign = turn(points);
            let truth = rational::orient2d(points[0], points[1], points[2]).sign();
            prop_assert!(sign.is_none_or(|sign| sign == truth));
            prop_assert!(sign.is_some() || exponents.iter().any(|e| e.abs() > 400));
        }
    }

    #[test]
    fn what_is_answered_and_what_is_not() {
        let tie = [[0.1, 0.1], [0.3, 0.3], [0.2, 0.2]];
        assert_eq!([orient2d(tie), turn(tie)], [Some(Sign::Zero); 2]);
        // Rounded differences: the turn of the rounded differences is different.
        let rounded = [[1.0, 1.0 + f64::EPSILON], [1.0 + f64::EPSILON, 1.0], [power_of_two(-60), power_of_two(-61)]];
        assert_eq!([orient2d(rounded), turn(rounded)], [None; 2]);
        // Products that underflow, and factors that are too large to be split.
        assert_eq!(turn([[1e-200, 1e-200], [1e-200, 1e-200], [0.0, 0.0]]), None);
        assert_eq!(turn([[1e300, 1.0], [1e300, 1.0], [0.0, 0.0]]), None);
        assert_eq!(turn([[5e-324, 0.0], [0.0, 1e300], [0.0, 0.0]]), None);
        assert_eq!(turn([[5e-324, 1.0], [1.0, 1e100], [0.0, 0.0]]), Some(Sign::Negative), "a subnormal factor");
        assert_eq!(orient2d([[1e200, 1e-200], [2e200, 2e-200], [0.0, 0.0]]), Some(Sign::Zero), "no common unit");
        assert_eq!(orient2d([[5e-324, 1.0], [1.0, 1.0], [0.0, 0.0]]), None, "a subnormal difference");
        assert_eq!(orient2d([[f64::MAX, 1.0], [1.0, 1.0], [-f64::MAX, 0.0]]), None, "an infinite difference");
    }
}
