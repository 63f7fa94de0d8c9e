//! Exact values of a pair's quantities.

use std::cmp::Ordering;

use rug::{Integer, Rational};

/// numerator / denominator · 2^exponent, with a positive denominator.
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

    /// Compares without a greatest common divisor.
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

    /// The quotient with a positive bound, rounded: off by some 2⁻⁵⁰ of itself.
    #[must_use]
    pub fn over(&self, bound: &Rational) -> f64 {
        if self.numerator.is_zero() {
            return 0.0;
        }
        let parts = [&self.numerator, bound.denom(), &self.denominator, bound.numer()];
        let [(n, e), (m, f), (d, g), (b, h)] = parts.map(Integer::to_f64_exp);
        let exponent = i64::from(e) + i64::from(f) - i64::from(g) - i64::from(h) + i64::from(self.exponent);
        // n m / (d b) is between ¼ and 4 in size: beyond these exponents it is zero or infinite all the same
        let exponent = i32::try_from(exponent.clamp(-2000, 2000)).expect("clamped");
        n * m / (d * b) * 2.0_f64.powi(exponent)
    }

    /// The value itself.
    #[must_use]
    pub fn value(&self) -> Rational {
        Rational::from((self.numerator.clone(), self.denominator.clone())) << self.exponent
    }
}
