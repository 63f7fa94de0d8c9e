//! Coordinates as text: read without loss, or an error.
//!
//! A decimal such as `0.1` is no double. Rounding it in silence would make a
//! scene something else than what its file says, so only decimals that *are*
//! doubles are read; `corpus fmt` turns the others into hex floats, and
//! [`Decimals`](crate::Decimals) rounds them where a suite asks for it.

use crate::bits::lowest_bit;
use crate::hexfloat::{self, HexError};

/// Why a text is not a coordinate.
#[derive(Clone, PartialEq, Debug)]
pub enum CoordinateError {
    /// Neither a decimal nor a hex float.
    Malformed,
    /// NaN or an infinity.
    NotFinite,
    /// Larger than every double.
    Overflow,
    /// Not zero, but nearest to zero.
    Underflow,
    /// Between two doubles; this is the nearer one.
    Inexact {
        /// The nearest double, ties to even.
        nearest: f64,
    },
    /// A hex float with more bits than a double has.
    TooManyBits,
    /// A text longer than 10,000 bytes.
    TooLong {
        /// Its length.
        bytes: usize,
    },
    /// One coordinate more than a scene may have.
    TooMany,
}

/// The longest text of a coordinate. The smallest double has 1,077 bytes when it is written out.
pub const MOST_BYTES: usize = 10_000;

fn not_too_long(text: &str) -> Result<(), CoordinateError> {
    if text.len() > MOST_BYTES { Err(CoordinateError::TooLong { bytes: text.len() }) } else { Ok(()) }
}

/// The double that a decimal or hex float denotes.
///
/// # Errors
/// [`CoordinateError`] where the text is no number or not exactly a double.
pub fn exact(text: &str) -> Result<f64, CoordinateError> {
    not_too_long(text)?;
    if hexfloat::looks_like(text) {
        return hexfloat::parse(text).map_err(|error| match error {
            HexError::Malformed => CoordinateError::Malformed,
            HexError::Inexact => CoordinateError::TooManyBits,
            HexError::Overflow => CoordinateError::Overflow,
        });
    }
    if let Some(is_double) = short(text) {
        let nearest = text.parse().map_err(|_| CoordinateError::Malformed)?;
        return if is_double { Ok(nearest) } else { Err(CoordinateError::Inexact { nearest }) };
    }
    let nearest = nearest(text)?;
    let decimal = Decimal::read(text).ok_or(CoordinateError::Malformed)?;
    if decimal == Decimal::of(nearest) { Ok(nearest) } else { Err(CoordinateError::Inexact { nearest }) }
}

/// Whether a decimal of at most 15 digits, without an exponent, is a double; none for other texts. Nearly all texts are so short.
///
/// With k of them behind the point, the digits are an integer m below 2^53, and m / 10^k is a double exactly where 5^k divides m.
fn short(text: &str) -> Option<bool> {
    let text = text.strip_prefix(['-', '+']).unwrap_or(text);
    let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
    let digits = || whole.bytes().chain(fraction.bytes());
    if !(1..=15).contains(&(whole.len() + fraction.len())) || !digits().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let m = digits().fold(0, |m, digit| 10 * m + u64::from(digit - b'0'));
    let fives = 5_u64.pow(u32::try_from(fraction.len()).ok()?);
    Some(m % fives == 0)
}

/// The double nearest to a decimal.
fn nearest(text: &str) -> Result<f64, CoordinateError> {
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
    Ok(nearest)
}

/// The absolute value of a decimal: digits · 10^exponent, without leading or
/// trailing zeros; zero has no digits.
#[derive(PartialEq, Eq, Debug)]
struct Decimal {
    digits: String,
    exponent: i64,
}

impl Decimal {
    /// Reads `[+-]D[.D][e[+-]D]`, with a digit before or behind the point.
    fn read(text: &str) -> Option<Decimal> {
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

    /// The exact value of a finite double: Rust writes as many digits as it is
    /// asked for, and a double whose lowest bit is 2^-k has k of them behind
    /// the point.
    fn of(x: f64) -> Decimal {
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
    // Beyond any double's range the exponent only needs to stay there.
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
            assert_eq!(exact(text).map(f64::to_bits), Ok(x.to_bits()), "{text}");
        }
    }

    #[test]
    fn what_is_no_double_is_refused_with_its_reason() {
        assert_eq!(exact("0.1"), Err(CoordinateError::Inexact { nearest: 0.1 }));
        assert_eq!(exact("9007199254740993"), Err(CoordinateError::Inexact { nearest: 9_007_199_254_740_992.0 }));
        for text in ["NaN", "nan", "-inf", "Infinity"] {
            assert_eq!(exact(text), Err(CoordinateError::NotFinite), "{text}");
        }
        for text in ["", "-", ".", "e5", "1e", "1e+", "0,5", "1 2", "1_000", " 1", "--1", "½"] {
            assert_eq!(exact(text), Err(CoordinateError::Malformed), "{text}");
        }
        for text in ["1e309", "-1e999999999999999999999999", "0x1p+1024"] {
            assert_eq!(exact(text), Err(CoordinateError::Overflow), "{text}");
        }
        assert_eq!(exact("1e-400"), Err(CoordinateError::Underflow));
        assert_eq!(exact("0x1.00000000000008p+0"), Err(CoordinateError::TooManyBits));
        let long = "0".repeat(MOST_BYTES);
        assert_eq!(exact(&long), Ok(0.0));
        assert_eq!(exact(&format!("{long}0")), Err(CoordinateError::TooLong { bytes: MOST_BYTES + 1 }));
        assert_eq!(exact(&format!("0x{long}p0")), Err(CoordinateError::TooLong { bytes: MOST_BYTES + 4 }));
    }

    fn rational(digits: &str, exponent: i32) -> Rational {
        let digits: Rational = Integer::from_str_radix(digits, 10).unwrap().into();
        digits * Rational::from(10).pow(exponent)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4_000))]

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
            prop_assert_eq!(exact(&text).is_ok(), is_double, "{}", text);
        }

        /// Written without an exponent, on both sides of the length from which there is no shorter way.
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
            let expected = if is_double { Ok(x.to_bits()) } else { Err(CoordinateError::Inexact { nearest: x }) };
            prop_assert_eq!(exact(&text).map(f64::to_bits), expected, "{}", text);
        }

        #[test]
        fn every_double_written_out_is_exact(bits: u64) {
            let x = f64::from_bits(bits);
            prop_assume!(x.is_finite());
            let written = format!("{x:.1074}");
            prop_assert_eq!(exact(&written).map(f64::to_bits), Ok(bits));
            // One unit in the last of so many places is never a double's.
            let off = format!("{x:.1074}1");
            prop_assert!(exact(&off).is_err());
        }

        #[test]
        fn no_text_panics(text in "\\PC{0,12}") {
            let _ = exact(&text);
        }
    }
}
