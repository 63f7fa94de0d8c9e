//! Coordinates as text: read without loss, or refused.
//!
//! A decimal denotes the double nearest to it, if that double can be printed as this decimal: with all its digits, with
//! as many digits as the decimal has (17 at most), or with as few as identify it among all doubles. So `0.1` denotes a
//! double, and so does any output of `repr`, `%.17g` and similar. The reading is lossless: printing the double again
//! gives the same decimal. A decimal of at most 15 digits is always reproduced, if its double is not subnormal.
//!
//! Other decimals have more digits than a double can hold. Rounding them silently would change the scene, so they are
//! refused; `corpus fmt` turns them into hex floats, and [`Decimals`](crate::Decimals) rounds them if a suite requests
//! it.

use std::fmt::LowerExp;

use crate::bits::lowest_bit;
use crate::hexfloat::{self, HexError};

mod short;

/// The reason why a text is not a coordinate.
#[derive(Clone, PartialEq, Debug)]
pub enum CoordinateError {
    /// The text is neither a decimal nor a hex float.
    Malformed,
    /// The text is NaN or an infinity.
    NotFinite,
    /// The number is larger than every double.
    Overflow,
    /// The number is not zero, but its nearest double is zero.
    Underflow,
    /// The decimal is between two doubles, and neither is printed as it.
    Inexact {
        /// The nearest double, ties to even.
        nearest: f64,
    },
    /// The hex float has more bits than a double.
    TooManyBits,
    /// The text is longer than 10,000 bytes.
    TooLong {
        /// The length of the text.
        bytes: usize,
    },
    /// The scene has more coordinates than allowed.
    TooMany,
}

/// The maximum length of a coordinate's text. The smallest double, written out in full, has 1,077 bytes.
pub const MOST_BYTES: usize = 10_000;

fn not_too_long(text: &str) -> Result<(), CoordinateError> {
    if text.len() > MOST_BYTES { Err(CoordinateError::TooLong { bytes: text.len() }) } else { Ok(()) }
}

/// The double that a decimal or hex float denotes.
///
/// # Errors
/// [`CoordinateError`] if the text is not a number, or no double is printed as it.
pub fn read(text: &str) -> Result<f64, CoordinateError> {
    if let Some(x) = short::read(text) {
        return Ok(x);
    }
    not_too_long(text)?;
    if hexfloat::looks_like(text) {
        return hexfloat::parse(text).map_err(|error| match error {
            HexError::Malformed => CoordinateError::Malformed,
            HexError::Inexact => CoordinateError::TooManyBits,
            HexError::Overflow => CoordinateError::Overflow,
        });
    }
    if is_short(text) {
        return text.parse().map_err(|_| CoordinateError::Malformed);
    }
    let (decimal, nearest) = nearest(text)?;
    if decimal.is_print_of(nearest) { Ok(nearest) } else { Err(CoordinateError::Inexact { nearest }) }
}

/// True if a text is exactly a double: a hex float, or a decimal that equals its double to the last digit.
#[must_use]
pub fn is_exact(text: &str) -> bool {
    let is_equal = |x: f64| hexfloat::looks_like(text) || Decimal::read(text) == Some(Decimal::of(x));
    read(text).is_ok_and(is_equal)
}

/// The single that a decimal denotes, by the rules of [`read`] with 9 digits instead of 17.
///
/// # Errors
/// As [`read`]; and if a decimal is beyond the largest single, or its nearest single is zero.
pub fn read_single(text: &str) -> Result<f32, CoordinateError> {
    not_too_long(text)?;
    if hexfloat::looks_like(text) {
        let double = read(text)?;
        let nearest = single(double);
        return if f64::from(nearest).to_bits() == double.to_bits() {
            Ok(nearest)
        } else if nearest.is_infinite() {
            Err(CoordinateError::Overflow)
        } else {
            Err(CoordinateError::Inexact { nearest: f64::from(nearest) })
        };
    }
    let (decimal, _) = nearest(text)?;
    let nearest: f32 = text.parse().map_err(|_| CoordinateError::Malformed)?;
    if nearest.is_infinite() {
        return Err(CoordinateError::Overflow);
    }
    if nearest == 0.0 && !decimal.digits.is_empty() {
        return Err(CoordinateError::Underflow);
    }
    let is_print = decimal.is_print(nearest.abs(), 9) || decimal == Decimal::of(f64::from(nearest));
    if is_print { Ok(nearest) } else { Err(CoordinateError::Inexact { nearest: f64::from(nearest) }) }
}

/// The single nearest to a double.
#[allow(clippy::cast_possible_truncation)] // the rounding that was asked for
fn single(x: f64) -> f32 {
    x as f32
}

/// True if a text is a decimal of at most 15 digits, without an exponent. Most texts that people type are that short.
///
/// Such a decimal is zero or between 10^-15 and 10^15, where doubles are normal, and its distance from its double is
/// less than half a unit of its 15th digit: the double, printed with 15 digits, is the decimal again.
fn is_short(text: &str) -> bool {
    let text = text.strip_prefix(['-', '+']).unwrap_or(text);
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let is_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    (1..=15).contains(&(whole.len() + fraction.len())) && is_digits(whole) && is_digits(fraction)
}

/// Parses a decimal; returns it with the double nearest to it.
fn nearest(text: &str) -> Result<(Decimal, f64), CoordinateError> {
    let bare = text.strip_prefix(['-', '+']).unwrap_or(text).to_ascii_lowercase();
    if matches!(bare.as_str(), "nan" | "inf" | "infinity") {
        return Err(CoordinateError::NotFinite);
    }
    let decimal = Decimal::read(text).ok_or(CoordinateError::Malformed)?;
    let nearest: f64 = text.parse().map_err(|_| CoordinateError::Malformed)?;
    if nearest.is_infinite() {
        return Err(CoordinateError::Overflow);
    }
    if nearest == 0.0 && !decimal.digits.is_empty() {
        return Err(CoordinateError::Underflow);
    }
    Ok((decimal, nearest))
}

/// The absolute value of a decimal: digits · 10^exponent, without leading or trailing zeros; zero has no digits.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Decimal {
    pub(crate) digits: String,
    pub(crate) exponent: i64,
}

impl Decimal {
    /// Reads `[+-]D[.D][e[+-]D]`, with a digit before or behind the point.
    pub(crate) fn read(text: &str) -> Option<Decimal> {
        let text = text.strip_prefix(['-', '+']).unwrap_or(text);
        let (mantissa, exponent) = match text.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, read_exponent(exponent)?),
            None => (text, 0),
        };
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits = format!("{whole}{fraction}");
        if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
            return None;
        }
        let fraction = i64::try_from(fraction.len()).ok()?;
        Some(Decimal::normalised(&digits, exponent.checked_sub(fraction)?))
    }

    /// True if a double can be printed as this decimal: with all its digits, with this decimal's number of digits up to
    /// 17, or with as few as identify it.
    fn is_print_of(&self, x: f64) -> bool {
        self.is_print(x.abs(), 17) || *self == Decimal::of(x)
    }

    /// True if a positive number can be printed as this decimal: with the same number of digits, up to `most`, or with
    /// as few as identify the number among all of its type. The two prints differ next to a power of two: there the
    /// nearest decimal with the fewest digits may denote another number.
    fn is_print(&self, x: impl LowerExp, most: usize) -> bool {
        let is = |text: String| Decimal::read(&text).is_some_and(|printed| printed == *self);
        let digits = self.digits.len();
        digits > 0 && digits <= most && (is(format!("{x:.*e}", digits - 1)) || is(format!("{x:e}")))
    }

    /// The exact value of a finite double: Rust writes as many digits as requested, and a double whose lowest bit is
    /// 2^-k has k digits behind the point.
    pub(crate) fn of(x: f64) -> Decimal {
        let places = usize::try_from(-lowest_bit(x).unwrap_or(0)).unwrap_or(0);
        let written = format!("{:.places$}", x.abs());
        let digits = written.replace('.', "");
        Decimal::normalised(&digits, -i64::try_from(places).expect("at most 1074"))
    }

    fn normalised(digits: &str, exponent: i64) -> Decimal {
        let significant = digits.trim_start_matches('0');
        let trimmed = significant.trim_end_matches('0');
        if trimmed.is_empty() {
            return Decimal { digits: String::new(), exponent: 0 };
        }
        let dropped = i64::try_from(significant.len() - trimmed.len()).unwrap_or(i64::MAX);
        Decimal { digits: trimmed.to_owned(), exponent: exponent.saturating_add(dropped) }
    }
}

fn read_exponent(text: &str) -> Option<i64> {
    let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    // Exponents beyond any double's range are clamped, which keeps them out of range.
    let magnitude = digits.parse::<i64>().unwrap_or(i64::MAX / 4).min(i64::MAX / 4);
    Some(if text.starts_with('-') { -magnitude } else { magnitude })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use rug::ops::Pow;
    use rug::{Integer, Rational};

    #[test]
    fn decimals_that_are_doubles() {
        for (text, x) in [
            ("8", 8.0_f64),
            ("-0.5", -0.5),
            ("+2.50", 2.5),
            ("1e3", 1000.0),
            ("5E-1", 0.5),
            ("0", 0.0),
            ("-0.000e9", -0.0),
            (".5", 0.5),
            ("5.", 5.0),
            ("0.1000000000000000055511151231257827021181583404541015625", 0.1),
            ("9007199254740992", 9_007_199_254_740_992.0),
            ("0x1.8p+1", 3.0),
        ] {
            assert!(is_exact(text), "{text}");
            assert_eq!(read(text).map(f64::to_bits), Ok(x.to_bits()), "{text}");
        }
    }

    #[test]
    fn decimals_that_doubles_are_printed_as() {
        for (text, x) in [
            ("0.1", 0.1_f64),
            ("-0.100", -0.1),
            ("1e-1", 0.1),
            ("0.10000000000000001", 0.1), // %.17g
            ("0.30000000000000004", 0.1 + 0.2),
            ("0.3", 0.3),
            ("1e23", 1e23),
            ("9.9999999999999992e22", 1e23), // %.17g
            ("1.7976931348623157e308", f64::MAX),
            ("5e-324", 5e-324),
            ("4.9e-324", 5e-324),                // Java
            ("4.9406564584124654e-324", 5e-324), // %.17g
            ("2.2250738585072014e-308", f64::MIN_POSITIVE),
            // The shortest decimal of 2^-44, and its nearest decimal of 17 digits. Its nearest decimal of 16 denotes
            // another double.
            ("5.684341886080802e-14", 2.0_f64.powi(-44)),
            ("5.6843418860808015e-14", 2.0_f64.powi(-44)),
        ] {
            assert_eq!(read(text).map(f64::to_bits), Ok(x.to_bits()), "{text}");
            assert!(!is_exact(text), "{text}");
        }
        for text in ["0.1000000000000000001", "0.10000000000000004", "3e-324", "1.79769313486231575e308"] {
            assert_eq!(read(text), Err(CoordinateError::Inexact { nearest: text.parse().unwrap() }), "{text}");
        }
    }

    #[test]
    fn singles_that_decimals_mean() {
        for (text, x) in [
            ("0.1", 0.1_f32),
            ("0.100000001", 0.1),
            ("16777217.0", 16_777_216.0),
            ("1e-45", 1e-45),
            ("3.4028235e38", f32::MAX),
        ] {
            let expected =
                if text == "16777217.0" { Err(CoordinateError::Inexact { nearest: x.into() }) } else { Ok(x) };
            assert_eq!(read_single(text), expected, "{text}");
        }
        assert_eq!(read_single("0x1p-3"), Ok(0.125));
        assert_eq!(read_single("0x1.000001p0"), Err(CoordinateError::Inexact { nearest: 1.0 }));
        assert_eq!(read_single("0.1000000001"), Err(CoordinateError::Inexact { nearest: 0.1_f32.into() }));
        assert_eq!(
            (read_single("1e39"), read_single("0x1p200")),
            (Err(CoordinateError::Overflow), Err(CoordinateError::Overflow))
        );
        assert_eq!(read_single("1e-60"), Err(CoordinateError::Underflow));
    }

    #[test]
    fn what_no_double_is_printed_as_is_refused_with_its_reason() {
        assert_eq!(read("9007199254740993"), Err(CoordinateError::Inexact { nearest: 9_007_199_254_740_992.0 }));
        for text in ["NaN", "nan", "-inf", "Infinity"] {
            assert_eq!(read(text), Err(CoordinateError::NotFinite), "{text}");
        }
        for text in ["", "-", ".", "e5", "1e", "1e+", "0,5", "1 2", "1_000", " 1", "--1", "½"] {
            assert_eq!(read(text), Err(CoordinateError::Malformed), "{text}");
        }
        for text in ["1e309", "-1e999999999999999999999999", "0x1p+1024"] {
            assert_eq!(read(text), Err(CoordinateError::Overflow), "{text}");
        }
        assert_eq!(read("1e-400"), Err(CoordinateError::Underflow));
        assert_eq!(read("0x1.00000000000008p+0"), Err(CoordinateError::TooManyBits));
        let long = "0".repeat(MOST_BYTES);
        assert_eq!(read(&long), Ok(0.0));
        assert_eq!(read(&format!("{long}0")), Err(CoordinateError::TooLong { bytes: MOST_BYTES + 1 }));
        assert_eq!(read(&format!("0x{long}p0")), Err(CoordinateError::TooLong { bytes: MOST_BYTES + 4 }));
    }

    fn rational(digits: &str, exponent: i32) -> Rational {
        let digits: Rational = Integer::from_str_radix(digits, 10).unwrap().into();
        digits * Rational::from(10).pow(exponent)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(predicament_effort::some_or_all(1_000, 4_000)))]

        #[test]
        fn exactness_agrees_with_rationals(
            digits in prop_oneof!["[1-9][0-9]{0,3}", "[1-9][0-9]{10,30}", "[1-9]?[0-9]{0,3}(5|25|125|625|0000)"],
            exponent in -30i32..30,
            negative: bool,
        ) {
            let truth = rational(&digits, exponent);
            let text = format!("{}{digits}e{exponent}", if negative { "-" } else { "" });
            let x: f64 = text.parse().unwrap();
            let is_double = Rational::from_f64(x.abs()) == Some(truth);
            prop_assert_eq!(is_exact(&text), is_double, "{}", text);
        }

        /// Written without an exponent, with lengths on both sides of the limit of the short test.
        #[test]
        fn exactness_of_short_decimals_agrees_with_rationals(
            digits in prop_oneof!["[0-9]{1,17}", "[0-9]{0,12}(5|25|125|625|0000)", "[0-9]{0,3}(0|5|25|75){1,6}"],
            behind in 0usize..17,
            sign in "[+-]?",
        ) {
            let behind = behind.min(digits.len());
            let (whole, fraction) = digits.split_at(digits.len() - behind);
            let truth = rational(&digits, -i32::try_from(behind).unwrap());
            let text = format!("{sign}{whole}.{fraction}");
            let x: f64 = text.parse().unwrap();
            let is_double = Rational::from_f64(x.abs()) == Some(truth);
            prop_assert_eq!(is_exact(&text), is_double, "{}", text);
            // The double of a decimal of 15 digits, printed with 15 digits, is that decimal: always read.
            let digits = digits.trim_matches('0').len();
            prop_assert!(digits > 15 || read(&text) == Ok(x), "{}", text);
        }

        /// C's `%.{n-1}e` and the shortest form: a printed double is read unchanged, and the double that was read can
        /// be printed as the text.
        #[test]
        fn what_programs_print_is_read_as_it_was(bits: u64, digits in 1usize..=17) {
            let x = f64::from_bits(bits);
            prop_assume!(x.is_finite());
            for text in [format!("{x:?}"), format!("{x:e}"), format!("{x:.16e}")] {
                prop_assert_eq!(read(&text).map(f64::to_bits), Ok(bits), "{}", text);
            }
            let text = format!("{x:.*e}", digits - 1);
            if let Ok(read) = read(&text) {
                let again = format!("{read:.*e}", digits - 1);
                prop_assert!(again == text || Decimal::read(&format!("{read:e}")) == Decimal::read(&text), "{}", text);
            } else {
                // With few digits, the largest doubles may round up beyond all doubles.
                let overflows = text.parse::<f64>().is_ok_and(f64::is_infinite);
                prop_assert!(digits == 16 || !x.is_normal() || overflows, "{} is refused", text);
            }
            // If the text is read as a single, the single is printed as it.
            if let Ok(single) = read_single(&text) {
                let decimal = Decimal::read(&text).unwrap();
                let places = decimal.digits.len().saturating_sub(1);
                let printed = [format!("{single:.places$e}"), format!("{single:e}")].map(|text| Decimal::read(&text).unwrap());
                prop_assert!(printed.contains(&decimal) || is_exact(&text), "{}", text);
            }
        }

        #[test]
        fn every_double_written_out_is_read(bits: u64) {
            let x = f64::from_bits(bits);
            prop_assume!(x.is_finite());
            let written = format!("{x:.1074}");
            prop_assert_eq!(read(&written).map(f64::to_bits), Ok(bits));
            // One unit in the last of so many decimal places never belongs to a double.
            let off = format!("{x:.1074}1");
            prop_assert!(read(&off).is_err());
        }

        #[test]
        fn no_text_panics(text in "\\PC{0,12}") {
            let _ = read(&text);
        }
    }
}
