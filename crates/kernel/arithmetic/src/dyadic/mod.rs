//! Exact dyadic numbers, sign × limbs × 2^(64·k), on the stack.
//!
//! A double is an integer times a power of two, and so is every sum and every product of doubles. A [`Number`] holds
//! such a value without rounding: 64-bit limbs, and the place of the lowest limb. The place keeps products of numbers
//! with distant exponents short (2^−1000 · 2^−1000 is one limb). Places count whole limbs, so numbers are added without
//! bit shifts.
//!
//! Determinants are nested sums of one to six products, so that is the only operation: [`Number::sum`] multiplies
//! directly into one accumulator in two's complement and inspects the sign once, at the end. A number is as long as its
//! value needs: a coordinate of one limb costs one row of multiplications, whatever the longest intermediate needs.
//! Limbs come from a [`Space`] on the caller's stack, so nothing is allocated or moved.
//!
//! # Space
//! Callers prove that the space suffices; a value that does not fit panics, and never wraps. Let all products of a sum
//! be multiples of 2^(64·l) and less than 2^h, in magnitude. The sum of N of them takes as many limbs as hold h −
//! 64·l + b + 1 bits, with b the logarithm of N rounded up, or two limbs if that is less.
//!
//! **If all inputs are integers below 2^(64n − 3)**, an intermediate of degree j takes j·n limbs, at least two.
//! Differences are below 2^(64n − 2), products of j differences below 2^(64jn − 2j). The remaining bits hold a sign and
//! the sum of 2^(2j − 1) products. Any one power of two may be factored out of the inputs beforehand
//! ([`Number::scaled`]), as it does not change signs of homogeneous polynomials.

mod limbs;

use core::cmp::Ordering;

use crate::Parts;

/// A stack buffer of limbs, handed out one after another.
#[derive(Debug)]
pub struct Space<'a>(&'a mut [u64]);

impl<'a> Space<'a> {
    /// A space of these limbs, which must be zero.
    #[inline(always)]
    #[must_use]
    pub fn new(zeros: &'a mut [u64]) -> Space<'a> {
        Space(zeros)
    }

    /// Takes the next limbs of the space.
    ///
    /// # Panics
    /// If fewer limbs remain: then the caller's proof is wrong.
    #[inline(always)]
    fn take(&mut self, limbs: usize) -> &'a mut [u64] {
        let (taken, rest) = core::mem::take(&mut self.0).split_at_mut_checked(limbs).expect("the space suffices");
        self.0 = rest;
        taken
    }
}

/// The number sign · magnitude · 2^(64·`low`).
///
/// The limbs of the magnitude are least significant first, without zeros at either end. Zero has no limbs.
#[derive(Clone, Copy, Debug)]
pub struct Number<'a> {
    /// The limbs of the magnitude; the first and the last are nonzero.
    pub limbs: &'a [u64],
    /// The place of the first limb; 0 for zero.
    pub low: i32,
    /// True if the number is below zero; without meaning for zero.
    pub negative: bool,
}

/// A product, and its role in a sum.
pub type Term<'a> = (Number<'a>, Number<'a>, Take);

/// The role of a product in a sum.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Take {
    /// Adds it.
    Plus,
    /// Subtracts it.
    Minus,
}

impl<'a> Number<'a> {
    /// The number zero.
    pub const ZERO: Number<'static> = Number { limbs: &[], low: 0, negative: false };
    /// The number one.
    pub const ONE: Number<'static> = Number { limbs: &[1], low: 0, negative: false };

    /// The number x·2^`shift`, exactly, for a finite x, in two limbs.
    ///
    /// Infinities and NaN count as an unspecified number of 2^1024 or more.
    ///
    /// # Panics
    /// If the space has too few limbs left: then the caller's proof is wrong.
    #[inline]
    #[must_use]
    #[allow(clippy::cast_possible_truncation)] // halves of 128 bits
    pub fn scaled(space: &mut Space<'a>, x: f64, shift: i32) -> Number<'a> {
        let Parts { significand, exponent, .. } = Parts::of_any(x);
        let exponent = exponent + shift;
        let wide = u128::from(significand) << exponent.rem_euclid(64);
        let limbs = space.take(2);
        limbs[0] = wide as u64;
        limbs[1] = (wide >> 64) as u64;
        Number::trimmed(limbs, exponent.div_euclid(64), x < 0.0)
    }

    /// The sum of products, exactly, in as few limbs as its terms allow.
    ///
    /// # Panics
    /// If the space has too few limbs left: then the caller's proof is wrong.
    #[inline(always)]
    #[must_use]
    pub fn sum<const N: usize>(space: &mut Space<'a>, terms: [Term; N]) -> Number<'a> {
        let (mut low, mut high, mut short) = (i32::MAX, i32::MIN, true);
        for (a, b, _) in &terms {
            if !a.is_zero() && !b.is_zero() {
                let place = a.low + b.low;
                short &= a.limbs.len() == 1 && b.limbs.len() == 1 && (low == i32::MAX || low == place);
                low = low.min(place);
                high = high.max(a.high() + b.high());
            }
        }
        if low == i32::MAX {
            return Number::ZERO;
        }
        // N products below 2^high, and a sign.
        let bits = high - 64 * low + N.next_power_of_two().ilog2().cast_signed() + 1;
        if short && bits <= 128 {
            return Number::short_sum(space, low, &terms);
        }
        #[allow(clippy::cast_sign_loss)] // high is above 64·low
        let window = space.take((bits as usize).div_ceil(64));
        for (a, b, take) in terms {
            if !a.is_zero() && !b.is_zero() {
                #[allow(clippy::cast_sign_loss)] // low is the least of these
                let at = (a.low + b.low - low) as usize;
                let minus = (a.negative != b.negative) != (take == Take::Minus);
                limbs::accumulate(&mut window[at..], a.limbs, b.limbs, minus);
            }
        }
        let negative = window.last().is_some_and(|top| top >> 63 == 1);
        if negative {
            limbs::negate(window);
        }
        Number::trimmed(window, low, negative)
    }

    /// The sum of products of one limb each, all at one place, with at most 128 bits including the sign.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation)] // halves of 128 bits
    fn short_sum(space: &mut Space<'a>, low: i32, terms: &[Term]) -> Number<'a> {
        let mut sum = 0_u128;
        for (a, b, take) in terms {
            if let ([x], [y]) = (a.limbs, b.limbs) {
                let product = u128::from(*x) * u128::from(*y);
                let minus = (a.negative != b.negative) != (*take == Take::Minus);
                sum = if minus { sum.wrapping_sub(product) } else { sum.wrapping_add(product) };
            }
        }
        let sum = sum.cast_signed();
        let magnitude = sum.unsigned_abs();
        let limbs = space.take(2);
        limbs[0] = magnitude as u64;
        limbs[1] = (magnitude >> 64) as u64;
        Number::trimmed(limbs, low, sum < 0)
    }

    #[inline(always)]
    fn trimmed(mut limbs: &'a [u64], mut low: i32, negative: bool) -> Number<'a> {
        while let [rest @ .., 0] = limbs {
            limbs = rest;
        }
        while let [0, rest @ ..] = limbs {
            limbs = rest;
            low += 1;
        }
        // Zero as a coordinate has the least exponent: its place would be the lowest of all.
        if limbs.is_empty() {
            return Number::ZERO;
        }
        Number { limbs, low, negative }
    }

    /// Returns true if the number is zero.
    #[inline(always)]
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.limbs.is_empty()
    }

    /// Returns true if the number is one.
    #[inline]
    #[must_use]
    pub fn is_one(self) -> bool {
        self.limbs == [1] && self.low == 0 && !self.negative
    }

    /// The comparison of the number with zero.
    #[inline]
    #[must_use]
    pub fn cmp0(self) -> Ordering {
        match (self.is_zero(), self.negative) {
            (true, _) => Ordering::Equal,
            (false, true) => Ordering::Less,
            (false, false) => Ordering::Greater,
        }
    }

    /// The place above the highest limb: |x| < 2^(64·top).
    #[inline]
    #[must_use]
    #[allow(clippy::cast_possible_wrap, clippy::cast_possible_truncation)] // a thousand limbs at most
    pub fn top(self) -> i32 {
        self.low + self.limbs.len() as i32
    }

    /// The least exponent e with |x| < 2^e, for a nonzero number.
    #[inline]
    #[must_use]
    pub fn high(self) -> i32 {
        let empty = self.limbs.last().map_or(0, |top| top.leading_zeros());
        64 * self.top() - empty.cast_signed()
    }

    /// The quotient |x/y| = m·2^e(1 + δ) as (m, e); `None` if x or y is zero.
    ///
    /// |δ| ≤ u(1 + 2^-7) with u = 2^-53, and m is between 2^63 and 2^65.
    #[must_use]
    pub fn quotient(self, divisor: Number) -> Option<(f64, i32)> {
        let (x, x_exponent) = self.leading()?;
        let (y, y_exponent) = divisor.leading()?;
        // Relative truncation errors: 2^-127 of x, 2^-63 of y, 2^-63 of the quotient. One rounding follows.
        let quotient = x / (y >> 64);
        #[allow(clippy::cast_precision_loss)]
        Some((quotient as f64, x_exponent - y_exponent - 64))
    }

    /// The leading 128 bits, the first of them set, and the exponent of the last.
    fn leading(self) -> Option<(u128, i32)> {
        let mut limbs = self.limbs.iter().rev().map(|&limb| u128::from(limb));
        let [top, next, last] = [limbs.next()?, limbs.next().unwrap_or(0), limbs.next().unwrap_or(0)];
        let empty = 64 * self.top() - self.high();
        Some(((top << 64 | next) << empty | last << empty >> 64, self.high() - 128))
    }
}

#[cfg(test)]
mod tests;
