//! Queries that are shorter than their scene.
//!
//! A scene may span more bits than a limb holds while each of its queries
//! spans few: clusters far from each other, figures of many sizes. Nothing is
//! known about such a query in advance; it is tried in one limb, and seen
//! whether that went well. Any finite points may be asked about.

use predicament_arithmetic::Fixed;
use predicament_predicates::Sign;

/// The differences to the last point in units of some power of two, if they
/// are doubles and span no more than 61 bits.
#[inline(always)]
pub(crate) fn rows<const D: usize, const N: usize>(points: [[f64; D]; N]) -> Option<[[Fixed<1>; D]; N]> {
    let differences = exact_differences(points)?;
    let largest = differences.as_flattened().iter().fold(0.0, |m, x| if x.abs() > m { x.abs() } else { m });
    // Of the biased exponent e, it is less than 2^(e - 1022); scaled it is less than 2^61.
    let exponent = largest.to_bits() >> 52;
    if !(60..2047).contains(&exponent) {
        return None;
    }
    let unit = f64::from_bits((1022 + 61 + 1023 - exponent) << 52);
    let mut whole = true;
    let rows = differences.map(|row| {
        row.map(|x| {
            let scaled = x * unit;
            let integer = Fixed::<1>::from_double(scaled);
            // (A difference that is lost in scaling is no integer either.)
            whole &= (integer.to_double() == scaled) & ((scaled == 0.0) == (x == 0.0));
            integer
        })
    });
    whole.then_some(rows)
}

/// The turn of three points, if their differences are doubles.
///
/// Whether it is left or right is which of two products is larger, and
/// products of two doubles have 106 bits: no common unit is needed.
#[inline(always)]
pub(crate) fn orient2d(points: [[f64; 2]; 3]) -> Option<Sign> {
    let [[ax, ay], [bx, by], _] = exact_differences(points)?;
    let [left, right] = [Product::new(ax, by)?, Product::new(ay, bx)?];
    Some(left.compare(right))
}

/// The differences to the last point, if all of them are doubles.
#[inline(always)]
fn exact_differences<const D: usize, const N: usize>(points: [[f64; D]; N]) -> Option<[[f64; D]; N]> {
    let last = points[N - 1];
    let mut exact = true;
    let differences = points.map(|point| {
        std::array::from_fn(|i| {
            let (a, b) = (point[i], last[i]);
            let difference = a - b;
            // Of the larger one of a and b the other is recovered without rounding (Dekker): if both
            // come out right, nothing was lost.
            exact &= (a - difference == b) & (difference + b == a);
            difference
        })
    });
    exact.then_some(differences)
}

/// significand · 2^exponent, with the sign of the significand.
#[derive(Clone, Copy)]
struct Product {
    significand: i128,
    exponent: u64,
}

impl Product {
    /// The exact product of two doubles that are zero or normal.
    #[inline(always)]
    fn new(x: f64, y: f64) -> Option<Product> {
        const HIDDEN: u64 = 1 << 52;
        let exponent = |x: f64| (x.to_bits() >> 52) & 0x7ff;
        let significand = |x: f64| (x.to_bits() & (HIDDEN - 1)) | HIDDEN;
        if (x == 0.0) | (y == 0.0) {
            return Some(Product { significand: 0, exponent: 0 });
        }
        let [ex, ey] = [exponent(x), exponent(y)];
        // (Infinite differences are not exact, so they don't come here.)
        if (ex == 0) | (ey == 0) {
            return None;
        }
        let magnitude = (u128::from(significand(x)) * u128::from(significand(y))).cast_signed();
        let negative = x.is_sign_negative() != y.is_sign_negative();
        Some(Product { significand: if negative { -magnitude } else { magnitude }, exponent: ex + ey })
    }

    /// The sign of self − other.
    #[inline(always)]
    fn compare(self, other: Product) -> Sign {
        // Significands have 105 or 106 bits: from 2^3 on the larger exponent decides, and shifts
        // by 3 keep that so.
        let shift = |mine: u64, theirs: u64| mine.saturating_sub(theirs).min(3);
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
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        #[test]
        fn an_answer_is_a_right_answer(p in prop::array::uniform3(prop::array::uniform2(double()))) {
            let truth = rational::orient2d(p[0], p[1], p[2]).sign();
            prop_assert!(orient2d(p).is_none_or(|sign| sign == truth));
            let by_rows = rows(p).map(|[a, b, _]| crate::integer::orient2d::<1, 2>([a, b]));
            prop_assert!(by_rows.is_none_or(|sign| sign == truth));
        }

        #[test]
        fn exact_means_exact(a in double(), b in double()) {
            let exact = crate::rational::orient2d([a, 0.0], [0.0, 1.0], [b, 0.0]).to_rational();
            let lost = rug::Rational::from_f64(a - b).is_none_or(|difference| difference != exact);
            prop_assert_eq!(exact_differences([[a], [b]]).is_none(), lost);
        }
    }

    #[test]
    fn short_queries_are_answered() {
        let tie = [[0.1, 0.1], [0.3, 0.3], [0.2, 0.2]];
        assert_eq!(orient2d(tie), Some(Sign::Zero));
        assert!(rows([[1.0, f64::EPSILON], [0.5, 0.25]]).is_some());
        assert!(rows([[1.0, 1e-25], [0.5, 0.0]]).is_none(), "83 bits");
        assert!(rows([[1e200, 1e-200], [0.0, 0.0]]).is_none(), "lost in scaling");
        assert_eq!(orient2d([[1e200, 1e-200], [2e200, 2e-200], [0.0, 0.0]]), Some(Sign::Zero), "no common unit");
        assert_eq!(orient2d([[5e-324, 1.0], [1.0, 1.0], [0.0, 0.0]]), None, "a subnormal difference");
        assert_eq!(orient2d([[f64::MAX, 1.0], [1.0, 1.0], [-f64::MAX, 0.0]]), None, "an infinite difference");
    }
}
