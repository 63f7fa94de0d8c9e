//! Exact values of a pair's quantities.

use std::cmp::Ordering;

use rug::{Integer, Rational};

/// The number numerator / denominator · 2^exponent, with a positive denominator.
#[derive(Clone, Debug)]
pub struct Quantity {
    pub(super) numerator: Integer,
    pub(super) denominator: Integer,
    pub(super) exponent: i32,
}

impl Quantity {
    pub(super) fn integer(numerator: Integer, exponent: i32) -> Quantity {
        Quantity { numerator, denominator: Integer::from(1), exponent }
    }

    /// Compares with a bound, without a greatest common divisor.
    #[must_use]
    pub fn compare(&self, bound: &Rational) -> Ordering {
        let (mut left, mut right) =
            (Integer::from(&self.numerator * bound.denom()), Integer::from(&self.denominator * bound.numer()));
        if self.exponent < 0 {
            right <<= self.exponent.unsigned_abs()
        } else {
            left <<= self.exponent.unsigned_abs()
        }
        left.cmp(&right)
    }

    /// The quotient with a positive bound, rounded: the relative error is about 2⁻⁵⁰.
    #[must_use]
    pub fn over(&self, bound: &Rational) -> f64 {
        if self.numerator.is_zero() {
            return 0.0;
        }
        let parts = [&self.numerator, bound.denom(), &self.denominator, bound.numer()];
        let [(n, e), (m, f), (d, g), (b, h)] = parts.map(Integer::to_f64_exp);
        let exponent = i64::from(e) + i64::from(f) - i64::from(g) - i64::from(h) + i64::from(self.exponent);
        // The size of n m / (d b) is between ¼ and 4: beyond these exponents the result is zero or infinite anyway
        let exponent = i32::try_from(exponent.clamp(-2000, 2000)).expect("clamped");
        // One power may not be a double although the quotient is. Of two halves, the first one is exact in any case.
        let half = exponent / 2;
        n * m / (d * b) * 2.0_f64.powi(half) * 2.0_f64.powi(exponent - half)
    }

    /// The exact value.
    #[must_use]
    pub fn value(&self) -> Rational {
        Rational::from((self.numerator.clone(), self.denominator.clone())) << self.exponent
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The quotient of (numerator, denominator, exponent) and a bound in the same form.
    fn quotient(of: (i32, i32, i32), bound: (i32, i32, i32)) -> f64 {
        let quantity = Quantity { numerator: of.0.into(), denominator: of.1.into(), exponent: of.2 };
        quantity.over(&(Rational::from((bound.0, bound.1)) << bound.2))
    }

    #[test]
    fn quotients_of_small_numbers_are_those_of_rationals() {
        let few = [1, 2, 3, 5, 7, 12, 100];
        for (n, d) in few.into_iter().flat_map(|n| few.map(|d| (n, d))) {
            for (b, m) in few.into_iter().flat_map(|b| few.map(|m| (b, m))) {
                for exponent in [-3, 0, 5] {
                    let exact = Rational::from((n * m, d * b)) << exponent;
                    let off: Rational = Rational::from_f64(quotient((n, d, exponent), (b, m, 0))).unwrap() / exact - 1;
                    assert!(off.abs() < Rational::from((1, 1_u64 << 50)), "{n} / {d} · 2^{exponent} over {b} / {m}");
                }
            }
        }
        assert_eq!(quotient((3, 4, 0), (3, 7, 0)), 1.75);
        assert_eq!(quotient((0, 4, 3), (3, 7, 0)), 0.0);
        assert_eq!(quotient((-3, 4, 1), (3, 1, 0)), -0.5);
    }

    #[test]
    fn quotients_are_right_where_the_power_of_two_alone_is_no_double() {
        // 2^-1060 is a subnormal double, and 2^1023 the largest power of two that is a double.
        assert_eq!(quotient((1, 1, -1060), (1, 1, 0)), f64::from_bits(1 << 14));
        assert_eq!(quotient((3, 1, -1030), (1, 1, 30)), f64::from_bits(3 << 14));
        assert_eq!(quotient((7, 8, 1023), (7, 8, 0)), 2.0_f64.powi(1023));
        assert_eq!(quotient((7, 4, 1023), (1, 1, 0)), 1.75 * 2.0_f64.powi(1023));
        assert_eq!(quotient((1, 3, 1024), (1, 1, 0)), 2.0_f64.powi(1022) / 0.75);
        assert_eq!(quotient((1, 1, -1000), (1, 1, 22)), f64::MIN_POSITIVE);
        assert_eq!(quotient((5, 1, -1076), (1, 1, 0)), f64::from_bits(1), "the nearest of the subnormals");
        // Larger than all doubles.
        assert_eq!(quotient((1, 1, 1024), (1, 1, 0)), f64::INFINITY);
        assert_eq!(quotient((1, 1, 3000), (1, 1, 0)), f64::INFINITY);
        assert_eq!(quotient((1, 1, -1076), (1, 1, 0)), 0.0);
        assert_eq!(quotient((1, 1, -3000), (1, 1, 0)), 0.0);
    }

    #[test]
    fn values_are_compared_with_rationals_in_all_orders() {
        let values = [(-3, 2, 2), (0, 5, 1), (1, 3, -2), (1, 3, 0), (7, 5, -1), (7, 5, 0), (7, 5, 3), (3, 1, 2)];
        for (n, d, exponent) in values {
            let quantity = Quantity { numerator: n.into(), denominator: d.into(), exponent };
            assert_eq!(quantity.value(), Rational::from((n, d)) * Rational::from((1, 4)) * (1 << (exponent + 2)));
            for (m, b, shift) in values {
                let bound = Rational::from((m, b)) << shift;
                assert_eq!(quantity.compare(&bound), quantity.value().cmp(&bound), "{n} / {d} · 2^{exponent}, {bound}");
            }
        }
        assert_eq!(Quantity::integer(Integer::from(-5), -1).value(), Rational::from((-5, 2)));
    }
}
