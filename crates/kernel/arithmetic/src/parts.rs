//! Doubles as integers times powers of two.
//!
//! Exact arithmetic starts from the significand and the exponent of a double. This module reads them from the bits,
//! including subnormals, for every representation, and assembles them again.

/// The number of bits of a double's fraction.
const FRACTION_BITS: u32 = 52;
/// The exponent of the lowest bit for exponent field 1, and the exponent of all subnormals.
const LOWEST: i32 = -1074;
/// The exponent field of infinities and NaN.
const NOT_FINITE: i32 = 0x7ff;

/// A finite double: ± significand · 2^exponent.
///
/// [`Parts::of`] does not normalize the significand: it has 53 bits for normal numbers and fewer for subnormals, with
/// the exponent of its lowest place.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Parts {
    /// True if the sign bit is set, also for −0.
    pub negative: bool,
    /// The magnitude in units of 2^`exponent`.
    pub significand: u64,
    /// The exponent of the unit.
    pub exponent: i32,
}

impl Parts {
    /// The parts of a double; `None` for infinities and NaN.
    #[inline(always)]
    #[must_use]
    pub const fn of(x: f64) -> Option<Parts> {
        if field(x) == NOT_FINITE { None } else { Some(Parts::of_any(x)) }
    }

    /// The parts of a finite double.
    ///
    /// Infinities and NaN count as an unspecified number of 2^1024 or more.
    #[inline(always)]
    #[must_use]
    pub(crate) const fn of_any(x: f64) -> Parts {
        let fraction = x.to_bits() & ((1 << FRACTION_BITS) - 1);
        let field = field(x);
        // Subnormals have the exponent of field 1 and no hidden bit.
        let (significand, field) = if field == 0 { (fraction, 1) } else { (fraction | 1 << FRACTION_BITS, field) };
        Parts { negative: x.is_sign_negative(), significand, exponent: field - 1 + LOWEST }
    }

    /// The double with this value; `None` if no double has it.
    #[must_use]
    pub const fn join(self) -> Option<f64> {
        // Outside these limits none of the 64 bits is in the range of doubles, and further exponents would overflow
        // their type.
        if self.significand != 0 && (self.exponent < LOWEST - 63 || self.exponent > 1023) {
            return None;
        }
        let magnitude = match (self.lowest(), self.highest()) {
            (Some(lowest), Some(highest)) => {
                if lowest < LOWEST || highest > 1024 || highest - lowest > 53 {
                    return None;
                }
                // In units of the lowest place of a double of this size. The shifts drop only zeros.
                let place = if highest - 53 > LOWEST { highest - 53 } else { LOWEST };
                let significand = if self.exponent >= place {
                    self.significand << (self.exponent - place)
                } else {
                    self.significand >> (place - self.exponent)
                };
                // A hidden bit adds one to the field; subnormals have no hidden bit.
                let field = (place - LOWEST).cast_unsigned() as u64;
                f64::from_bits((field << FRACTION_BITS) + significand)
            }
            _ => 0.0,
        };
        Some(if self.negative { -magnitude } else { magnitude })
    }

    /// The exponent of the lowest bit that is set; `None` for zero.
    #[inline(always)]
    #[must_use]
    pub const fn lowest(self) -> Option<i32> {
        if self.significand == 0 { None } else { Some(self.exponent + self.significand.trailing_zeros().cast_signed()) }
    }

    /// The least e with |x| < 2^e; `None` for zero.
    #[inline(always)]
    #[must_use]
    pub const fn highest(self) -> Option<i32> {
        if self.significand == 0 {
            None
        } else {
            Some(self.exponent + (u64::BITS - self.significand.leading_zeros()).cast_signed())
        }
    }

    /// The same value with an odd significand; zero is unchanged.
    #[inline]
    #[must_use]
    pub const fn odd(self) -> Parts {
        match self.lowest() {
            None => self,
            Some(exponent) => {
                let significand = self.significand >> self.significand.trailing_zeros();
                Parts { significand, exponent, ..self }
            }
        }
    }
}

/// The normal double 2^`exponent`, for −1022 ..= 1023.
///
/// # Panics
/// In builds with overflow checks, if there is no such normal double.
#[inline(always)]
#[must_use]
pub const fn power_of_two(exponent: i32) -> f64 {
    debug_assert!(-1022 <= exponent && exponent <= 1023, "a power of two that is no normal double");
    #[allow(clippy::cast_sign_loss)] // never negative
    f64::from_bits(((exponent + 1023) as u64) << FRACTION_BITS)
}

/// The eleven bits of the exponent.
///
/// For a normal double it is the exponent of the highest bit plus 1023, for zeros and subnormals zero.
#[inline(always)]
#[allow(clippy::cast_possible_truncation)] // eleven bits
pub(crate) const fn field(x: f64) -> i32 {
    (x.to_bits() >> FRACTION_BITS & 0x7ff) as i32
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use rug::Rational;

    use super::*;

    fn value(parts: Parts) -> Rational {
        let magnitude = Rational::from(parts.significand) << parts.exponent;
        if parts.negative { -magnitude } else { magnitude }
    }

    /// Checks that the parts of these bits have the number's value, and give the bits again.
    fn splits_and_joins(bits: u64) {
        let x = f64::from_bits(bits);
        let Some(parts) = Parts::of(x) else {
            assert!(!x.is_finite(), "{x:e} is refused");
            return;
        };
        let truth = Rational::from_f64(x).expect("infinities and NaN have no parts");
        assert_eq!(parts.join().map(f64::to_bits), Some(bits));
        assert!(parts.significand < 1 << 53 && (LOWEST..=971).contains(&parts.exponent), "{parts:?}");
        assert_eq!(parts.negative, x.is_sign_negative());
        let odd = parts.odd();
        assert_eq!([value(parts), value(odd)], [truth.clone(), truth.clone()]);
        assert_eq!(odd.join().map(f64::to_bits), Some(bits));
        assert_eq!(odd.significand % 2 == 1, x != 0.0);
        match (parts.lowest(), parts.highest()) {
            (Some(lowest), Some(highest)) => {
                let power = |exponent: i32| Rational::from(1) << exponent;
                assert_eq!(lowest, odd.exponent);
                let magnitude = truth.abs();
                assert!(power(highest - 1) <= magnitude && magnitude < power(highest));
            }
            ends => assert!(x == 0.0 && ends == (None, None)),
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(10_000))]

        #[test]
        fn every_bit_pattern_splits_and_joins(
            bits in any::<u64>(),
            // Exponents at both ends, fractions of few bits; subnormals, −0, infinities and NaN occur.
            field in prop_oneof![0..3_u64, 0x7fc..=0x7ff_u64, 0..=0x7ff_u64],
            bit in 0..=52_u32,
            negative: bool,
        ) {
            splits_and_joins(bits);
            let sign = u64::from(negative) << 63;
            let lone = (1_u64 << bit) & ((1 << FRACTION_BITS) - 1);
            for fraction in [bits & ((1 << FRACTION_BITS) - 1), lone, lone.wrapping_sub(1) & ((1 << FRACTION_BITS) - 1)] {
                splits_and_joins(sign | field << FRACTION_BITS | fraction);
            }
        }

        /// A joined double has the value, and if joining fails, no double has it.
        #[test]
        fn what_joins_is_exact(
            negative: bool,
            significand in any::<u64>(),
            dropped in 0..64_u32,
            zeros in 0..64_u32,
            exponent in prop_oneof![-1200..1100_i32, -1140..-1010_i32, 900..1030_i32],
        ) {
            let parts = Parts { negative, significand: significand >> dropped >> zeros << zeros, exponent };
            let truth = value(parts);
            let nearest = truth.to_f64();
            let exact = nearest.is_finite() && Rational::from_f64(nearest).is_some_and(|nearest| nearest == truth);
            let expected = exact.then_some(if negative && truth == 0 { -0.0 } else { nearest });
            prop_assert_eq!(parts.join().map(f64::to_bits), expected.map(f64::to_bits));
        }
    }

    #[test]
    fn known_doubles() {
        let parts =
            |x: f64| Parts::of(x).map(|Parts { negative, significand, exponent }| (negative, significand, exponent));
        assert_eq!(parts(1.0), Some((false, 1 << 52, -52)));
        assert_eq!(parts(-0.0), Some((true, 0, -1074)));
        assert_eq!(parts(5e-324), Some((false, 1, -1074)));
        assert_eq!(parts(-f64::MIN_POSITIVE), Some((true, 1 << 52, -1074)));
        assert_eq!(parts(f64::MIN_POSITIVE.next_down()), Some((false, (1 << 52) - 1, -1074)));
        assert_eq!(parts(f64::MAX), Some((false, (1 << 53) - 1, 971)));
        for x in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN, -f64::NAN, f64::from_bits(0x7ff0_0000_0000_0001)] {
            assert_eq!(parts(x), None, "{x}");
        }
        let join = |significand: u64, exponent: i32| Parts { negative: false, significand, exponent }.join();
        assert_eq!(join(1, 1024), None);
        assert_eq!(join(1, -1075), None);
        assert_eq!([join(1, i32::MAX), join(2, i32::MIN)], [None; 2]);
        assert_eq!(join(2, -1075), Some(5e-324));
        assert_eq!(join((1 << 53) + 1, 0), None);
        assert_eq!(join(0, 9999), Some(0.0));
    }

    #[test]
    fn powers_of_two_are_those_of_the_library() {
        for exponent in -1022..=1023 {
            assert_eq!(power_of_two(exponent), 2_f64.powi(exponent), "2^{exponent}");
        }
    }
}
