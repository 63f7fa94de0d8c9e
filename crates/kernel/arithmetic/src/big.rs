//! Integers of any length, for the few computations whose length is not known beforehand.
//!
//! Vertices that constructed vertices define have coordinates of any length, and these are kept in lowest terms.
//! Perturbed determinants of constructed vertices have coefficients of any length. Both need sums, products, greatest
//! common divisors and exact quotients, and nothing else. Numbers on the stack ([`Fixed`](crate::Fixed),
//! [`dyadic`](crate::dyadic)) serve everything that is shorter.
//!
//! Algorithms: schoolbook products and, from 40 limbs on, Karatsuba's; the greatest common divisor by Lehmer's
//! algorithm (Knuth, The Art of Computer Programming 2, 4.5.2, algorithm L); exact quotients from the low end
//! (Jebelean, An algorithm for exact division, 1993).

use alloc::vec::Vec;
use core::cmp::Ordering;
use core::ops::{Add, AddAssign, Mul, Neg, Shl, Sub, SubAssign};

mod divisor;
mod limbs;

/// The length in limbs up to which products that are added in place allocate nothing.
const FEW: usize = 32;

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

    /// Adds a product in place.
    pub fn add_product(&mut self, a: &BigInt, b: &BigInt) {
        self.add_product_of(a.negative != b.negative, &a.limbs, &b.limbs);
    }

    /// Adds the product of two magnitudes in place, with its sign.
    ///
    /// Limbs are least significant first. The product of a few limbs allocates nothing.
    pub fn add_product_of(&mut self, negative: bool, a: &[u64], b: &[u64]) {
        let length = a.len() + b.len();
        if length <= FEW {
            let mut product = [0; FEW];
            limbs::multiply(&mut product[..length], a, b);
            self.add_magnitude(negative, &product[..length]);
        } else {
            self.add_magnitude(negative, &limbs::product(a, b));
        }
    }

    /// Adds a magnitude in place, with its sign; limbs are least significant first.
    pub fn add_magnitude(&mut self, negative: bool, other: &[u64]) {
        let other = limbs::trimmed(other);
        if self.negative == negative || self.is_zero() {
            self.negative = negative && !(self.is_zero() && other.is_empty());
            if self.limbs.len() < other.len() {
                self.limbs.resize(other.len(), 0);
            }
            match limbs::add(&mut self.limbs, other) {
                0 => {}
                carry => self.limbs.push(carry),
            }
        } else if limbs::compare(&self.limbs, other) == Ordering::Less {
            self.limbs.resize(other.len(), 0);
            limbs::subtract_from(&mut self.limbs, other);
            limbs::trim(&mut self.limbs);
            self.negative = negative;
        } else {
            limbs::subtract(&mut self.limbs, other);
            limbs::trim(&mut self.limbs);
            self.negative &= !self.limbs.is_empty();
        }
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

impl From<i64> for BigInt {
    fn from(number: i64) -> BigInt {
        BigInt::new(number < 0, [number.unsigned_abs()].into())
    }
}

/// The product with a power of two.
impl Shl<u32> for BigInt {
    type Output = BigInt;

    fn shl(self, places: u32) -> BigInt {
        BigInt::new(self.negative, limbs::shifted(&self.limbs, places))
    }
}

impl AddAssign<&BigInt> for BigInt {
    fn add_assign(&mut self, other: &BigInt) {
        self.add_magnitude(other.negative, &other.limbs);
    }
}

impl SubAssign<&BigInt> for BigInt {
    fn sub_assign(&mut self, other: &BigInt) {
        self.add_magnitude(!other.negative, &other.limbs);
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
