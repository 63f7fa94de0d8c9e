//! Exact numbers as decimals, rounded in a stated direction.

use std::cmp::Ordering;

use rug::{Integer, Rational};

fn power_of_ten(exponent: u32) -> Integer {
    Integer::from(Integer::u_pow_u(10, exponent))
}

/// The decimal with at most `decimals` decimals, rounded up, without trailing zeros.
#[must_use]
pub fn rounded_up(x: &Rational, decimals: u32) -> String {
    let scale = power_of_ten(decimals);
    let scaled = Rational::from(x * &scale).ceil().numer().clone();
    let (whole, rest) = scaled.clone().div_rem(scale);
    let sign = if scaled < 0 { "-" } else { "" };
    let digits = format!("{:0>width$}", rest.abs().to_string(), width = decimals as usize);
    let text = format!("{sign}{}.{digits}", whole.abs());
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// The decimal with three digits, rounded down, so that a slack is never overstated.
#[must_use]
pub fn scientific_down(x: &Rational) -> String {
    let size = x.clone().abs();
    if size == 0 {
        return "0".to_owned();
    }
    // 10^exponent ≤ size < 10^(exponent + 1)
    let mut exponent = 0_i32;
    let scaled = |exponent: i32| match exponent.cmp(&0) {
        Ordering::Less => Rational::from(&size * power_of_ten(exponent.unsigned_abs())),
        _ => Rational::from(&size / power_of_ten(exponent.unsigned_abs())),
    };
    while scaled(exponent) >= 10 {
        exponent += 1;
    }
    while scaled(exponent) < 1 {
        exponent -= 1;
    }
    let hundredths: Rational = scaled(exponent) * 100;
    let digits = if *x > 0 { hundredths.floor() } else { hundredths.ceil() };
    let (digits, exponent) = if digits == 1000 { (Rational::from(100), exponent + 1) } else { (digits, exponent) };
    let sign = if *x > 0 { "" } else { "-" };
    let digits = digits.numer().to_u32().expect("three digits");
    format!("{sign}{}.{:02}e{exponent}", digits / 100, digits % 100)
}

/// A decimal number of three digits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Decimal {
    /// 100 to 999, for 1.00 to 9.99.
    digits: u32,
    /// The negated power of ten.
    exponent: u32,
}

impl Decimal {
    /// The number digits/100 · 10^−exponent.
    ///
    /// # Panics
    /// If `digits` does not have three digits.
    #[must_use]
    pub fn new(digits: u32, exponent: u32) -> Decimal {
        assert!((100..1000).contains(&digits), "three digits");
        Decimal { digits, exponent }
    }

    /// The value as a rational.
    #[must_use]
    pub fn value(self) -> Rational {
        Rational::from((self.digits, 100)) / power_of_ten(self.exponent)
    }
}

impl std::fmt::Display for Decimal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}.{:02}e-{}", self.digits / 100, self.digits % 100, self.exponent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_round_up() {
        for ((n, d), text) in
            [((2, 3), "0.667"), ((-2, 3), "-0.666"), ((5, 1), "5"), ((21, 2), "10.5"), ((1, 9999), "0.001")]
        {
            assert_eq!(rounded_up(&Rational::from((n, d)), 3), text);
        }
    }

    #[test]
    fn slacks_round_down() {
        for ((n, d), text) in [
            ((2, 3), "6.66e-1"),
            ((-2, 3), "-6.67e-1"),
            ((9999, 1), "9.99e3"),
            ((-9999, 1), "-1.00e4"),
            ((1, 100_000), "1.00e-5"),
            ((0, 1), "0"),
        ] {
            assert_eq!(scientific_down(&Rational::from((n, d))), text);
        }
        assert_eq!(Decimal::new(192, 6).to_string(), "1.92e-6");
        assert_eq!(Decimal::new(192, 6).value(), Rational::from((192, 100_000_000)));
    }
}
