//! Integers of any length on the stack, built for sums of products.
//!
//! Every polynomial here is nested sums of one to six products, so that is the
//! one operation: [`Number::sum`] multiplies straight into one accumulator in
//! two's complement and looks at the sign once, at the end. Lengths are those
//! of the values: a coordinate of one limb costs one row of multiplications,
//! whatever the longest intermediate needs. Limbs come from a [`Space`] on the
//! caller's stack, so nothing is allocated and nothing moved; and nothing
//! rounds, as callers prove that the space suffices.

use predicament_predicates::Sign;

/// Limbs to compute in, handed out one after another.
pub(super) struct Space<'a>(&'a mut [u64]);

impl<'a> Space<'a> {
    /// All of these limbs, which must be zero.
    pub fn new(zeros: &'a mut [u64]) -> Space<'a> {
        Space(zeros)
    }

    /// # Panics
    /// If there is less left: that is a wrong proof at the caller.
    #[inline(always)]
    fn take(&mut self, limbs: usize) -> &'a mut [u64] {
        let (taken, rest) = std::mem::take(&mut self.0).split_at_mut(limbs);
        self.0 = rest;
        taken
    }
}

/// sign · magnitude · 2^(64·`low`), the limbs of the magnitude least
/// significant first, without zeros at either end. Zero has no limbs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Number<'a> {
    pub limbs: &'a [u64],
    pub low: i32,
    pub negative: bool,
}

/// A product, and what a sum does with it.
pub(super) type Term<'a> = (Number<'a>, Number<'a>, Take);

/// What a sum does with a product.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Take {
    Plus,
    Minus,
}

impl<'a> Number<'a> {
    pub const ZERO: Number<'static> = Number { limbs: &[], low: 0, negative: false };
    pub const ONE: Number<'static> = Number { limbs: &[1], low: 0, negative: false };

    /// x·2^`shift`, exactly, for a finite x, in two limbs.
    #[inline]
    #[allow(clippy::cast_possible_truncation)] // an 11-bit field; halves of 128 bits
    pub fn scaled(space: &mut Space<'a>, x: f64, shift: i32) -> Number<'a> {
        let bits = x.to_bits();
        let fraction = bits & ((1 << 52) - 1);
        let field = (bits >> 52 & 0x7ff) as i32;
        // Subnormals have the exponent of field 1 and no hidden bit.
        let significand = if field == 0 { fraction } else { fraction | 1 << 52 };
        let exponent = field.max(1) - 1075 + shift;
        let wide = u128::from(significand) << exponent.rem_euclid(64);
        let limbs = space.take(2);
        limbs[0] = wide as u64;
        limbs[1] = (wide >> 64) as u64;
        Number::trimmed(limbs, exponent.div_euclid(64), x < 0.0)
    }

    /// The sum of products, exactly, in as few limbs as its terms allow.
    ///
    /// # Panics
    /// If the space has too few limbs left: that is a wrong proof at the caller.
    #[inline(always)]
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
                accumulate(&mut window[at..], a.limbs, b.limbs, minus);
            }
        }
        let negative = window.last().is_some_and(|top| top >> 63 == 1);
        if negative {
            negate(window);
        }
        Number::trimmed(window, low, negative)
    }

    /// Products of one limb each, all at one place, whose sum has 128 bits with its sign.
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
        Number { limbs, low, negative }
    }

    #[inline(always)]
    pub fn is_zero(self) -> bool {
        self.limbs.is_empty()
    }

    #[inline]
    pub fn is_one(self) -> bool {
        self.limbs == [1] && self.low == 0 && !self.negative
    }

    pub fn sign(self) -> Sign {
        match (self.is_zero(), self.negative) {
            (true, _) => Sign::Zero,
            (false, true) => Sign::Negative,
            (false, false) => Sign::Positive,
        }
    }

    /// The place above the highest limb: |x| < 2^(64·top).
    #[inline]
    #[allow(clippy::cast_possible_wrap, clippy::cast_possible_truncation)] // a thousand limbs at most
    pub fn top(self) -> i32 {
        self.low + self.limbs.len() as i32
    }

    /// The least exponent e with |x| < 2^e, for what is not zero.
    #[inline]
    pub fn high(self) -> i32 {
        let empty = self.limbs.last().map_or(0, |top| top.leading_zeros());
        64 * self.top() - empty.cast_signed()
    }

    /// m and e with |x/y| = m·2^e(1 + δ), |δ| ≤ u(1 + 2^-7), u = 2^-53, and m
    /// between 2^63 and 2^65; none where x or y is zero.
    pub fn quotient(self, divisor: Number) -> Option<(f64, i32)> {
        let (x, x_exponent) = self.leading()?;
        let (y, y_exponent) = divisor.leading()?;
        // Cut off: x by 2^-127, y by 2^-63, their quotient by 2^-63, in relation to
        // themselves. One rounding follows.
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

/// Adds a·b to the window or subtracts it, modulo the window's length.
#[inline(never)]
fn accumulate(window: &mut [u64], a: &[u64], b: &[u64], minus: bool) {
    let (long, short) = if a.len() < b.len() { (b, a) } else { (a, b) };
    for (i, &factor) in short.iter().enumerate() {
        let row = &mut window[i..];
        if minus { subtract_row(row, long, factor) } else { add_row(row, long, factor) }
    }
}

/// The carry is a limb at most: (2^64 − 1)² + 2(2^64 − 1) = 2^128 − 1.
#[inline(always)]
#[allow(clippy::cast_possible_truncation)] // halves of 128 bits
fn add_row(row: &mut [u64], long: &[u64], factor: u64) {
    let mut carry = 0;
    let (body, above) = row.split_at_mut(long.len());
    for (limb, &other) in body.iter_mut().zip(long) {
        let wide = u128::from(factor) * u128::from(other) + u128::from(*limb) + u128::from(carry);
        *limb = wide as u64;
        carry = (wide >> 64) as u64;
    }
    for limb in above {
        let (sum, over) = limb.overflowing_add(carry);
        *limb = sum;
        if !over {
            return;
        }
        carry = 1;
    }
}

/// The borrow is a limb at most: of (2^64 − 1)² + 2^64 − 1 = (2^64 − 1)·2^64
/// the lower half is zero, and the upper half of anything less leaves room for one.
#[inline(always)]
#[allow(clippy::cast_possible_truncation)] // halves of 128 bits
fn subtract_row(row: &mut [u64], long: &[u64], factor: u64) {
    let mut borrow = 0;
    let (body, above) = row.split_at_mut(long.len());
    for (limb, &other) in body.iter_mut().zip(long) {
        let wide = u128::from(factor) * u128::from(other) + u128::from(borrow);
        let (difference, under) = limb.overflowing_sub(wide as u64);
        *limb = difference;
        borrow = (wide >> 64) as u64 + u64::from(under);
    }
    for limb in above {
        let (difference, under) = limb.overflowing_sub(borrow);
        *limb = difference;
        if !under {
            return;
        }
        borrow = 1;
    }
}

fn negate(window: &mut [u64]) {
    let mut carry = true;
    for limb in window {
        (*limb, carry) = (!*limb).overflowing_add(u64::from(carry));
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use rug::{Integer, Rational, integer::Order};

    use super::*;

    fn value(number: Number) -> Rational {
        let magnitude = Rational::from(Integer::from_digits(number.limbs, Order::Lsf)) << (64 * number.low);
        if number.negative { -magnitude } else { magnitude }
    }

    /// Limbs that are often all zeros, all ones or a lone bit; trimmed by the test.
    fn limbs() -> impl Strategy<Value = (Vec<u64>, i32, bool)> {
        let limb = prop_oneof![any::<u64>(), Just(0), Just(u64::MAX), (0..64_u32).prop_map(|bit| 1 << bit)];
        (proptest::collection::vec(limb, 0..6), -3..4, any::<bool>())
    }

    fn check<const N: usize>(parts: &[(Vec<u64>, i32, bool)], takes: u8) {
        let number = |i: usize| {
            let (limbs, low, negative) = &parts[i % parts.len()];
            Number::trimmed(limbs, *low, *negative)
        };
        let take = |i: usize| if takes >> i & 1 == 1 { Take::Minus } else { Take::Plus };
        let terms: [Term; N] = std::array::from_fn(|i| (number(2 * i), number(2 * i + 1), take(i)));
        let mut limbs = [0; 32];
        let sum = Number::sum(&mut Space::new(&mut limbs), terms);
        let mut truth = Rational::new();
        for (a, b, take) in terms {
            let product = value(a) * value(b);
            if take == Take::Plus { truth += product } else { truth -= product }
        }
        assert_eq!(value(sum), truth);
        assert_eq!(sum.sign(), Sign::from(truth.cmp0()));
        assert!(sum.limbs.first() != Some(&0) && sum.limbs.last() != Some(&0));
        if !sum.is_zero() {
            let magnitude = Rational::from(truth.abs_ref());
            let power = |exponent: i32| Rational::from(1) << exponent;
            assert!(magnitude < power(sum.high()) && magnitude >= power(sum.high() - 1));
            assert!(magnitude < power(64 * sum.top()));
            let (bits, exponent) = sum.leading().expect("not zero");
            let cut = &magnitude - Rational::from(bits) * power(exponent);
            assert!(bits >> 127 == 1 && cut >= 0 && cut < power(exponent));
            check_quotient(sum, number(0));
        }
    }

    fn check_quotient(x: Number, y: Number) {
        let Some((mantissa, exponent)) = x.quotient(y) else {
            assert!(x.is_zero() || y.is_zero());
            return;
        };
        let power = |exponent: i32| Rational::from(1) << exponent;
        let truth = (value(x) / value(y)).abs();
        assert!((2f64.powi(63)..=2f64.powi(65)).contains(&mantissa));
        let error = Rational::from_f64(mantissa).expect("finite") * power(exponent) - &truth;
        assert!(error.abs() <= truth * (power(-53) + power(-60)));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(2000)))]

        #[test]
        fn sums_of_products_are_those_of_gmp(parts in proptest::collection::vec(limbs(), 12), takes in any::<u8>()) {
            check::<1>(&parts, takes);
            check::<2>(&parts, takes);
            check::<3>(&parts, takes);
            check::<6>(&parts, takes);
        }

        /// Numbers of a limb have a way of their own.
        #[test]
        fn short_sums_too(parts in proptest::collection::vec(any::<(u64, bool)>(), 12), bits in 0..64_u32, takes in any::<u8>()) {
            let parts: Vec<_> = parts.into_iter().map(|(limb, negative)| (vec![limb >> bits], 0, negative)).collect();
            check::<2>(&parts, takes);
            check::<3>(&parts, takes);
            check::<6>(&parts, takes);
            // Cancellation to zero.
            check::<2>(&parts[..2], 0b10);
        }

        #[test]
        fn doubles_are_scaled_exactly(bits in any::<u64>(), shift in -2200..2200_i32) {
            let x = f64::from_bits(bits);
            prop_assume!(x.is_finite());
            let mut limbs = [0; 2];
            let number = Number::scaled(&mut Space::new(&mut limbs), x, shift);
            prop_assert_eq!(value(number), Rational::from_f64(x).unwrap() << shift);
        }
    }

    #[test]
    fn one_is_one() {
        assert!(Number::ONE.is_one() && !Number::ZERO.is_one());
        assert_eq!((value(Number::ONE), value(Number::ZERO)), (Rational::from(1), Rational::new()));
    }
}
