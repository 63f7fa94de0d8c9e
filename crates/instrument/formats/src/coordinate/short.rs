//! Decimals that programs print, read without an allocation.
//!
//! Programs print doubles with as few digits as identify them (`repr`), or with 17 (`%.17g`). Tests in machine
//! integers accept nearly all such decimals; the others are left to the general reader.

/// The maximum number of digits: such an integer has 64 bits.
const MOST_DIGITS: usize = 19;
/// The least integer of more than 15 digits.
const FIFTEEN: u64 = 1_000_000_000_000_000;

/// A positive decimal of at most 19 digits: `digits · 10^exponent`, where the last digit is not zero.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Short {
    digits: u64,
    exponent: i32,
}

impl Short {
    /// Reads `D[.D][e[+-]D]`, with a digit before or behind the point; `None` if it is not one, is zero, or is long.
    #[inline(always)]
    fn read(text: &[u8]) -> Option<Short> {
        let (mut digits, mut at) = (0_u64, 0);
        let run = |digits: &mut u64, at: &mut usize| {
            while let Some(digit) = text.get(*at).map(|byte| byte.wrapping_sub(b'0')).filter(|digit| *digit < 10) {
                *digits = digits.wrapping_mul(10).wrapping_add(u64::from(digit));
                *at += 1;
            }
        };
        run(&mut digits, &mut at);
        let (mut count, mut exponent) = (at, 0);
        if text.get(at) == Some(&b'.') {
            at += 1;
            let point = at;
            run(&mut digits, &mut at);
            count += at - point;
            exponent = -i32::try_from(at - point).ok()?;
        }
        if count > MOST_DIGITS {
            // Zeros in front do not count.
            count -= text.iter().take_while(|byte| matches!(byte, b'0' | b'.')).filter(|byte| **byte == b'0').count();
            if count > MOST_DIGITS {
                return None;
            }
        }
        if at < text.len() {
            if !matches!(text[at], b'e' | b'E') {
                return None;
            }
            let (minus, written) = match text.get(at + 1)? {
                b'-' => (true, &text[at + 2..]),
                b'+' => (false, &text[at + 2..]),
                _ => (false, &text[at + 1..]),
            };
            if written.is_empty() || written.len() > 4 {
                return None;
            }
            let mut power = 0_i32;
            for byte in written {
                power = 10 * power + i32::from(byte.is_ascii_digit().then(|| byte - b'0')?);
            }
            exponent += if minus { -power } else { power };
        }
        if digits == 0 {
            return None;
        }
        while digits.is_multiple_of(10) {
            digits /= 10;
            exponent += 1;
        }
        Some(Short { digits, exponent })
    }

    /// The double nearest to the decimal if one operation makes it: both the digits and the power of ten are doubles,
    /// and a product or quotient is rounded once (Clinger 1990).
    #[inline(always)]
    fn nearest(self) -> Option<f64> {
        const POWERS: [f64; 23] = [
            1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
            1e19, 1e20, 1e21, 1e22,
        ];
        if self.digits > 1 << f64::MANTISSA_DIGITS {
            return None;
        }
        #[allow(clippy::cast_precision_loss)] // at most 2^53
        let digits = self.digits as f64;
        let power = POWERS.get(usize::try_from(self.exponent.unsigned_abs()).ok()?)?;
        Some(if self.exponent < 0 { digits / power } else { digits * power })
    }

    /// True if the decimal is nearer to a double than half a unit of its last digit; false also if that is not known.
    /// Then the double, printed with as many digits, is the decimal. The decimal has at most 17 digits.
    ///
    /// Let x = f · 2^e, and the decimal m · 10^k. Both sides of 2 |m · 10^k − f · 2^e| < 10^k are multiplied by
    /// 2^-e · 10^-k, where −70 ≤ e ≤ 0 and −22 ≤ k ≤ 0: all terms are integers below 2^128, as m < 2^57 and f < 2^53.
    fn is_print(self, x: f64) -> bool {
        let bits = x.to_bits();
        let (fraction, biased) = (bits & ((1 << 52) - 1), bits >> 52 & 0x7ff);
        let (Ok(down), Ok(places)) = (u32::try_from(1075 - biased.cast_signed()), u32::try_from(-self.exponent)) else {
            return false;
        };
        if biased == 0 || down > 70 || places > 22 || self.digits >= 100_000_000_000_000_000 {
            return false;
        }
        let decimal = u128::from(self.digits) << down;
        let double = u128::from(fraction | 1 << 52) * 10_u128.pow(places);
        decimal.abs_diff(double) < 1 << down >> 1
    }
}

/// The double that a decimal denotes, if a short test shows that the double can be printed as the decimal.
///
/// A decimal of at most 15 digits whose double is normal is less than half a unit of its 15th digit away from it: the
/// double, printed with 15 digits, is the decimal again.
#[inline]
pub(super) fn read(text: &str) -> Option<f64> {
    let (minus, bare) = match text.as_bytes() {
        [b'-', bare @ ..] => (true, bare),
        [b'+', bare @ ..] => (false, bare),
        bare => (false, bare),
    };
    let decimal = Short::read(bare)?;
    let x = decimal.nearest().or_else(|| fast_float2::parse(bare).ok()).filter(|x: &f64| x.is_normal())?;
    let is_shortest = || Short::read(zmij::Buffer::new().format_finite(x).as_bytes()) == Some(decimal);
    let is_print = decimal.digits < FIFTEEN || decimal.is_print(x) || is_shortest();
    is_print.then_some(if minus { -x } else { x })
}

#[cfg(test)]
mod tests {
    use super::super::{Decimal, read as any};
    use super::*;
    use proptest::prelude::*;

    /// The shortest decimal of a double is read, by the short test if all programs print the same one.
    fn is_accepted(x: f64) -> Result<(), TestCaseError> {
        let text = format!("{x}");
        prop_assert_eq!(any(&text), Ok(x));
        let is_unique = zmij::Buffer::new().format_finite(x).trim_end_matches(".0") == text;
        prop_assert!(read(&text) == Some(x) || !is_unique, "{text}");
        Ok(())
    }

    /// The double is in the middle between two decimals of 16 digits, both of which denote it.
    #[test]
    fn both_shortest_decimals_are_accepted() {
        let x = 931_544_616_569.281_3;
        is_accepted(x).expect("accepted");
        for text in ["931544616569.2812", "931544616569.2813"] {
            assert_eq!(any(text), Ok(x));
        }
        assert_eq!(read("931544616569.2813"), None);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(predicament_effort::some_or_all(2_000, 200_000)))]

        #[test]
        fn what_is_accepted_is_a_print(bits: u64, digits in 0..20_usize, near in -40_i32..20, step in -3_i64..=3) {
            let doubles = [f64::from_bits(bits), f64::from_bits(bits >> 12 | 1023 << 52) * 2_f64.powi(near)];
            for x in doubles.into_iter().filter(|x| x.is_finite() && *x != 0.0) {
                let printed = [format!("{x:.digits$e}"), format!("{x:e}"), format!("{x}"), format!("{x:.digits$}")];
                for text in printed {
                    // Neighbours of a print, in its last digit.
                    let moved = match text.find(['e']).unwrap_or(text.len()) {
                        end if text.as_bytes()[end - 1].is_ascii_digit() => {
                            let digit = (i64::from(text.as_bytes()[end - 1] - b'0') + step).rem_euclid(10);
                            format!("{}{digit}{}", &text[..end - 1], &text[end..])
                        }
                        _ => continue,
                    };
                    if let Some(found) = read(&moved) {
                        prop_assert_eq!(found.to_bits(), moved.parse::<f64>().unwrap().to_bits());
                        let decimal = Decimal::read(&moved).unwrap();
                        prop_assert!(decimal.is_print_of(found), "{} {}", moved, found);
                        prop_assert_eq!(any(&moved), Ok(found));
                    }
                }
            }
        }

        #[test]
        fn what_programs_print_is_accepted(bits: u64, near in -13_i32..40) {
            let x = f64::from_bits(bits >> 12 | 1023 << 52) * 2_f64.powi(near);
            is_accepted(x)?;
            // A tie between two decimals of 17 digits is left to the general reader.
            prop_assert_eq!(any(&format!("{x:.16e}")), Ok(x));
        }
    }
}
