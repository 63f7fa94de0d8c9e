//! Doubles as text without loss: C99 hexadecimal floating point.
//!
//! A hex float shows the bits, so that reading and writing need no rounding, and files that differ in a coordinate
//! differ in the text. The canonical form is that of C's `%a`: one digit before the point (1, or 0 for zero and
//! subnormals, whose exponent is always -1022), no trailing zeros behind it, a signed decimal exponent: `0x1.8p+1`,
//! `-0x0p+0`, `0x0.0000000000001p-1022`.

use std::fmt::Write;

use predicament_arithmetic::Parts;

use crate::bits::HIGHEST;

const FRACTION_BITS: u32 = 52;
const FRACTION: u64 = (1 << FRACTION_BITS) - 1;

/// The reason why a text is not a double in hexadecimal.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum HexError {
    /// The text is not of the form `[-]0xH[.H]p[+-]D`.
    Malformed,
    /// The number has more significant bits than a double has, or bits below 2^-1074.
    Inexact,
    /// The magnitude is 2^1024 or more.
    Overflow,
}

/// The canonical text of a finite double.
///
/// Infinities and NaN have no hexadecimal form: the result is `inf`, `-inf` and `NaN`, which [`parse`] refuses.
#[must_use]
pub fn format(x: f64) -> String {
    let Some(Parts { negative, significand, exponent }) = Parts::of(x) else {
        return x.to_string();
    };
    // The stored significand has 52 bits behind the point.
    let (lead, fraction) = (significand >> FRACTION_BITS, significand & FRACTION);
    let exponent = if significand == 0 { 0 } else { exponent + FRACTION_BITS.cast_signed() };
    let mut text = String::from(if negative { "-0x" } else { "0x" });
    write!(text, "{lead}").expect("strings grow");
    if fraction != 0 {
        let digits = format!("{fraction:013x}");
        write!(text, ".{}", digits.trim_end_matches('0')).expect("strings grow");
    }
    write!(text, "p{exponent:+}").expect("strings grow");
    text
}

/// True if a text starts like a hex float, with `0x` or `0X` after an optional sign.
pub(crate) fn looks_like(text: &str) -> bool {
    let digits = match text.as_bytes() {
        [b'-' | b'+', digits @ ..] => digits,
        digits => digits,
    };
    matches!(digits, [b'0', b'x' | b'X', ..])
}

/// The double that a hex float denotes, in canonical form or not.
///
/// # Errors
/// [`HexError`] if the text is not a number, or the number is not a double.
pub fn parse(text: &str) -> Result<f64, HexError> {
    let (negative, rest) = match text.as_bytes().first() {
        Some(b'-') => (true, &text[1..]),
        Some(b'+') => (false, &text[1..]),
        _ => (false, text),
    };
    let rest = rest.strip_prefix("0x").or_else(|| rest.strip_prefix("0X")).ok_or(HexError::Malformed)?;
    let (mantissa, exponent) = rest.split_once(['p', 'P']).ok_or(HexError::Malformed)?;
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    if whole.is_empty() || !whole.bytes().chain(fraction.bytes()).all(|b| b.is_ascii_hexdigit()) {
        return Err(HexError::Malformed);
    }
    let magnitude = compose(whole, fraction, signed_decimal(exponent)?)?;
    Ok(if negative { -magnitude } else { magnitude })
}

/// A decimal exponent; an exponent beyond any double's range is clamped, which keeps it out of range.
fn signed_decimal(text: &str) -> Result<i64, HexError> {
    let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return Err(HexError::Malformed);
    }
    let magnitude = digits.parse::<i64>().unwrap_or(i64::MAX / 4).min(i64::MAX / 4);
    Ok(if text.starts_with('-') { -magnitude } else { magnitude })
}

/// The number whole.fraction · 2^exponent, digits in base 16.
fn compose(whole: &str, fraction: &str, exponent: i64) -> Result<f64, HexError> {
    let digits = format!("{whole}{fraction}");
    let significant = digits.trim_start_matches('0');
    let trimmed = significant.trim_end_matches('0');
    if trimmed.is_empty() {
        return Ok(0.0);
    }
    let count = |n: usize| i64::try_from(n).unwrap_or(i64::MAX / 8);
    let dropped = count(significant.len() - trimmed.len());
    let lowest_digit = exponent + 4 * (dropped - count(fraction.len()));
    // Seventeen hex digits, the first and last not zero, hold at least 66 bits.
    let odd_or_even = u64::from_str_radix(trimmed, 16).map_err(|_| HexError::Inexact)?;
    let zeros = odd_or_even.trailing_zeros();
    let odd = odd_or_even >> zeros;
    let low = lowest_digit + i64::from(zeros);
    let width = i64::from(u64::BITS - odd.leading_zeros());
    let high = low + width - 1;
    if high > HIGHEST {
        return Err(HexError::Overflow);
    }
    let exponent = i32::try_from(low).map_err(|_| HexError::Inexact)?;
    Parts { negative: false, significand: odd, exponent }.join().ok_or(HexError::Inexact)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn canonical_forms() {
        for (x, text) in [
            (3.0, "0x1.8p+1"),
            (-0.0, "-0x0p+0"),
            (0.0, "0x0p+0"),
            (0.1, "0x1.999999999999ap-4"),
            (5e-324, "0x0.0000000000001p-1022"),
            (f64::MIN_POSITIVE, "0x1p-1022"),
            (f64::MAX, "0x1.fffffffffffffp+1023"),
            (f64::MIN_POSITIVE.next_down(), "0x0.fffffffffffffp-1022"),
        ] {
            assert_eq!(format(x), text);
            assert_eq!(parse(text).unwrap().to_bits(), x.to_bits(), "{text}");
        }
    }

    #[test]
    fn other_spellings_of_the_same_number() {
        for text in ["0x3p+0", "0x0.3p4", "0X6P-1", "+0x0003.000p0", "0x30000000000000000000000000p-100"] {
            assert_eq!(parse(text), Ok(3.0), "{text}");
        }
        assert_eq!(parse("0x1p-1074"), Ok(5e-324));
        assert_eq!(parse("0x0p-99999999999999999999"), Ok(0.0));
    }

    #[test]
    fn what_is_no_double_is_refused() {
        for text in ["", "0x", "0xp0", "0x1", "0x1.p", "0x1p", "0x1p+", "0x.8p0", "0xgp0", "1p3", "0x1p1.5", "0x1p+-3"]
        {
            assert_eq!(parse(text), Err(HexError::Malformed), "{text}");
        }
        for text in
            ["0x1.00000000000008p0", "0x1p-1075", "0x1.8p-1074", "0x1p-99999999999999999999", "0x10000000000000001p0"]
        {
            assert_eq!(parse(text), Err(HexError::Inexact), "{text}");
        }
        for text in ["0x1p1024", "0x8p1021", "0x1p99999999999999999999"] {
            assert_eq!(parse(text), Err(HexError::Overflow), "{text}");
        }
        for x in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            assert_eq!(parse(&format(x)), Err(HexError::Malformed));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(predicament_effort::some_or_all(4_000, 20_000)))]

        #[test]
        fn every_bit_pattern_round_trips(bits: u64) {
            let x = f64::from_bits(bits);
            prop_assume!(x.is_finite());
            prop_assert_eq!(parse(&format(x)).map(f64::to_bits), Ok(bits));
        }

        #[test]
        fn subnormals_round_trip(bits in 0u64..1 << 53, negative: bool) {
            let bits = bits | (u64::from(negative) << 63);
            prop_assert_eq!(parse(&format(f64::from_bits(bits))).map(f64::to_bits), Ok(bits));
        }

        #[test]
        fn integers_in_hex_denote_themselves(m in 0u64..1 << 53, shift in -40i32..40) {
            let text = format!("0x{m:x}p{shift}");
            let by_rug = rug::Rational::from(m) << shift;
            prop_assert_eq!(parse(&text), Ok(by_rug.to_f64()));
        }

        #[test]
        fn no_text_panics(text in "[-+]?0[xX][0-9a-fA-F.]{0,24}[pP][-+]?[0-9]{0,6}") {
            let _ = parse(&text);
        }
    }
}
