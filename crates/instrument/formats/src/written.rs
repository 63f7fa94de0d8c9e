//! Coordinates as they were written: decimals, as integers over one power of ten.
//!
//! A typed `0.1` is not the double that it denotes. Decimals of one scene have one common denominator, so that exact
//! computations with them are computations with integers. A decimal of at most 15 digits is the shortest decimal of its
//! double, so that the text of such data need not be kept.

use std::collections::BTreeMap;

use crate::coordinate::Decimal;
use crate::hexfloat;

/// The most digits of a numerator; products of them are for the judge, which has no limit.
const MOST_DIGITS: i64 = 36;

/// The most digits of a decimal that its double gives back.
const CERTAIN: usize = 15;

/// The coordinates of a scene in decimals: integers divided by a power of ten.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Written {
    digits: u32,
    numerators: Vec<i128>,
}

/// The reason why coordinates have no decimals.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum NotWritten {
    /// The shortest decimal of a double has more than 15 digits: it was computed, or written with more digits.
    Computed {
        /// The index of the coordinate.
        at: usize,
        /// The double.
        x: f64,
    },
    /// The decimals have too many digits for one common denominator.
    TooLong {
        /// The index of the coordinate.
        at: usize,
        /// The double nearest to the decimal.
        x: f64,
    },
    /// Two different decimals have the same double, so that the double does not tell which of them was meant.
    Same {
        /// The double.
        x: f64,
    },
}

impl std::fmt::Display for NotWritten {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            NotWritten::Computed { at, x } => {
                write!(f, "coordinate {at} is {x:?}, whose decimal has more than {CERTAIN} digits: a computed number")
            }
            NotWritten::TooLong { at, x } => {
                write!(f, "coordinate {at}, near {x:?}, needs more than {MOST_DIGITS} digits beside the others")
            }
            NotWritten::Same { x } => write!(f, "two different decimals have the double {x:?}"),
        }
    }
}

impl std::error::Error for NotWritten {}

impl NotWritten {
    /// The fix, for suites.
    pub const CURE: &str = "remove `truth`, or write decimals of at most 15 digits";
}

impl Written {
    /// Integers over 10^`digits`.
    #[must_use]
    pub fn new(digits: u32, numerators: Vec<i128>) -> Written {
        Written { digits, numerators }
    }

    /// The decimals of doubles: their texts where these were kept, else the shortest decimals, of at most 15 digits.
    ///
    /// # Errors
    /// [`NotWritten`] if a double has no such decimal.
    pub fn of(coordinates: &[f64], kept: &Kept) -> Result<Written, NotWritten> {
        let decimals = coordinates.iter().enumerate().map(|(at, &x)| kept.decimal(at, x));
        let decimals: Vec<Decimal> = decimals.collect::<Result<_, _>>()?;
        let lowest = decimals.iter().map(|decimal| decimal.exponent).min().unwrap_or(0).min(0);
        let numerator = |(at, decimal): (usize, &Decimal)| {
            let zeros = decimal.exponent - lowest;
            let too_long = || NotWritten::TooLong { at, x: coordinates[at] };
            let digits = i64::try_from(decimal.digits.len()).map_err(|_| too_long())?;
            if decimal.digits.is_empty() {
                return Ok(0);
            }
            if digits + zeros > MOST_DIGITS {
                return Err(too_long());
            }
            let integer: i128 = decimal.digits.parse().map_err(|_| too_long())?;
            let magnitude = integer * 10_i128.pow(u32::try_from(zeros).map_err(|_| too_long())?);
            Ok(if coordinates[at].is_sign_negative() { -magnitude } else { magnitude })
        };
        let numerators = decimals.iter().enumerate().map(numerator).collect::<Result<_, _>>()?;
        Ok(Written { digits: u32::try_from(-lowest).unwrap_or(u32::MAX), numerators })
    }

    /// The number of digits behind the point: numerators are over ten to this power.
    #[must_use]
    pub fn digits(&self) -> u32 {
        self.digits
    }

    /// The numerators, coordinate by coordinate.
    #[must_use]
    pub fn numerators(&self) -> &[i128] {
        &self.numerators
    }

    /// The doubles nearest to the decimals.
    ///
    /// # Panics
    /// If a decimal is beyond the largest double.
    #[must_use]
    pub fn doubles(&self) -> Vec<f64> {
        let nearest = |n: &i128| -> f64 { format!("{n}e-{}", self.digits).parse().expect("a decimal") };
        self.numerators.iter().map(nearest).collect()
    }

    /// The numerators as doubles, if all of them are doubles: a scene that is similar to the written one.
    #[must_use]
    pub fn scaled(&self) -> Option<Vec<f64>> {
        let integer = |&n: &i128| {
            #[allow(clippy::cast_precision_loss)] // at most 53 bits
            (n.unsigned_abs() <= 1 << 53).then_some(n as f64)
        };
        self.numerators.iter().map(integer).collect()
    }

    /// A coordinate as a decimal.
    #[must_use]
    pub fn text(&self, at: usize) -> String {
        let n = self.numerators[at];
        let sign = if n < 0 { "-" } else { "" };
        let places = self.digits as usize;
        let digits = format!("{:0>width$}", n.unsigned_abs(), width = places + 1);
        let (whole, fraction) = digits.split_at(digits.len() - places);
        let fraction = fraction.trim_end_matches('0');
        if fraction.is_empty() { format!("{sign}{whole}") } else { format!("{sign}{whole}.{fraction}") }
    }
}

/// The texts of decimals by their doubles, as a reader of a scene has met them.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Kept {
    /// The decimal of each double, by its bits; `None` if there were two.
    of: BTreeMap<u64, Option<Decimal>>,
}

impl Kept {
    /// Keeps the text of a double.
    pub(crate) fn keep(&mut self, x: f64, text: &str) {
        let decimal = if hexfloat::looks_like(text) { Some(Decimal::of(x)) } else { Decimal::read(text) };
        let Some(decimal) = decimal else { return };
        let met = self.of.entry(x.to_bits()).or_insert_with(|| Some(decimal.clone()));
        if met.as_ref() != Some(&decimal) {
            *met = None;
        }
    }

    fn decimal(&self, at: usize, x: f64) -> Result<Decimal, NotWritten> {
        match self.of.get(&x.to_bits()) {
            Some(Some(decimal)) => Ok(decimal.clone()),
            Some(None) => Err(NotWritten::Same { x }),
            None => {
                let shortest = Decimal::read(&format!("{x:e}")).filter(|decimal| decimal.digits.len() <= CERTAIN);
                shortest.ok_or(NotWritten::Computed { at, x })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Decimals;

    fn of(texts: &[&str]) -> Result<Written, NotWritten> {
        let reader = Decimals::new(true).keeping(true);
        let doubles: Vec<f64> = texts.iter().map(|text| reader.read(text).unwrap()).collect();
        Written::of(&doubles, &reader.kept())
    }

    #[test]
    fn decimals_are_integers_over_one_power_of_ten() {
        let written = of(&["0.1", "-2.50", "1e2", "0", "5413000.123456789012"]).unwrap();
        let numerators = [100_000_000_000, -2_500_000_000_000, 100_000_000_000_000, 0, 5_413_000_123_456_789_012];
        assert_eq!(written, Written::new(12, numerators.to_vec()));
        assert_eq!(written.text(1), "-2.5");
        assert_eq!(written.text(4), "5413000.123456789012");
        assert_eq!(written.doubles()[..2], [0.1, -2.5]);
        assert_eq!(written.scaled(), None);
        assert_eq!(of(&["0.5", "-1"]).unwrap().scaled(), Some(vec![5.0, -10.0]));
    }

    #[test]
    fn doubles_without_a_text_are_their_shortest_decimals() {
        let none = Kept::default();
        assert_eq!(Written::of(&[0.1, 3.0], &none), Ok(Written::new(1, vec![1, 30])));
        assert_eq!(Written::of(&[0.1 + 0.2], &none), Err(NotWritten::Computed { at: 0, x: 0.1 + 0.2 }));
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        assert_eq!(of(&["1e30", "1e-30"]), Err(NotWritten::TooLong { at: 0, x: 1e30 }));
        assert_eq!(of(&["0.1", "0.10000000000000001"]), Err(NotWritten::Same { x: 0.1 }));
        assert_eq!(of(&["0x1p-1", "0.5"]), Ok(Written::new(1, vec![5, 5])));
    }
}
