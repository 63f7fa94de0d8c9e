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

    /// The value itself.
    #[must_use]
    pub fn value(&self) -> Rational {
        Rational::from((self.numerator.clone(), self.denominator.clone())) << self.exponent
    }
}
