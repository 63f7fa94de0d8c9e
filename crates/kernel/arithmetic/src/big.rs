//! Integers of any length, for the few computations whose length is not known beforehand.
//!
//! Vertices that constructed vertices define have coordinates of any length, and these are kept in lowest terms. The
//! computation needs sums, products, greatest common divisors and exact quotients, and nothing else. Numbers on the
//! stack ([`Fixed`](crate::Fixed), [`dyadic`](crate::dyadic)) serve everything that is shorter.
//!
//! Algorithms: schoolbook products and, from 40 limbs on, Karatsuba's; the greatest common divisor by Lehmer's
//! algorithm (Knuth, The Art of Computer Programming 2, 4.5.2, algorithm L); exact quotients from the low end
//! (Jebelean, An algorithm for exact division, 1993).

use alloc::vec::Vec;
use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

mod divisor;
mod limbs;

/// An integer of any length: a sign and the limbs of the magnitude.
#[derive(Clone, PartialEq, Eq, Hash, Debug, Default)]
pub struct BigInt {
    /// False for zero.
    negative: bool,
    /// The limbs, least significant first; the last one is not zero.
    limbs: Vec<u64>,
}

impl BigInt {
    /// Zero.
    pub const ZERO: BigInt = BigInt { negative: false, limbs: Vec::new() };

    /// The integer with this sign and these limbs, least significant first.
    #[must_use]
    pub fn new(negative: bool, mut limbs: Vec<u64>) -> BigInt {
        limbs::trim(&mut limbs);
        BigInt { negative: negative && !limbs.is_empty(), limbs }
    }

    /// The limbs of the magnitude, least significant first; the last one is not zero.
    #[must_use]
    pub fn limbs(&self) -> &[u64] {
        &self.limbs
    }

    /// Returns true for numbers below zero.
    #[must_use]
    pub fn is_negative(&self) -> bool {
        self.negative
    }

    /// Returns true for zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.limbs.is_empty()
    }

    /// The order of the integer and zero.
    #[must_use]
    pub fn cmp0(&self) -> Ordering {
        match (self.is_zero(), self.negative) {
            (true, _) => Ordering::Equal,
            (false, true) => Ordering::Less,
            (false, false) => Ordering::Greater,
        }
    }

    /// The greatest common divisor, not negative; that of zero and a number is the number's magnitude.
    #[must_use]
    pub fn gcd(&self, other: &BigInt) -> BigInt {
        BigInt::new(false, divisor::gcd(self.limbs.clone(), other.limbs.clone()))
    }

    /// The quotient by a divisor of the integer.
    ///
    /// The result is unspecified if the divisor does not divide the integer.
    ///
    /// # Panics
    /// If the divisor is zero.
    #[must_use]
    pub fn div_exact(&self, divisor: &BigInt) -> BigInt {
        assert!(!divisor.is_zero(), "a divisor that is not zero");
        let limbs = divisor::exact(&self.limbs, &divisor.limbs);
        BigInt::new(self.negative != divisor.negative, limbs)
    }

    /// The sum, with the sign of the second number given.
    fn plus(&self, negative: bool, other: &[u64]) -> BigInt {
        if self.negative == negative {
            return BigInt::new(negative, limbs::sum(&self.limbs, other));
        }
        match limbs::compare(&self.limbs, other) {
            Ordering::Less => BigInt::new(negative, limbs::difference(other, &self.limbs)),
            Ordering::Equal => BigInt::ZERO,
            Ordering::Greater => BigInt::new(self.negative, limbs::difference(&self.limbs, other)),
        }
    }
}

impl From<u64> for BigInt {
    fn from(number: u64) -> BigInt {
        BigInt::new(false, [number].into())
    }
}

impl Neg for BigInt {
    type Output = BigInt;

    fn neg(mut self) -> BigInt {
        self.negative = !self.negative && !self.is_zero();
        self
    }
}

impl Add for &BigInt {
    type Output = BigInt;

    fn add(self, other: &BigInt) -> BigInt {
        self.plus(other.negative, &other.limbs)
    }
}

impl Sub for &BigInt {
    type Output = BigInt;

    fn sub(self, other: &BigInt) -> BigInt {
        self.plus(!other.negative, &other.limbs)
    }
}

impl Mul for &BigInt {
    type Output = BigInt;

    fn mul(self, other: &BigInt) -> BigInt {
        BigInt::new(self.negative != other.negative, limbs::product(&self.limbs, &other.limbs))
    }
}

#[cfg(test)]
mod tests;
