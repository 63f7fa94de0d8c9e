//! The exact number α of a point αa + (1 − α)c.
//!
//! A third is not a double. So α is a fraction of whole numbers, and two shares are equal if their values are.

use alloc::{borrow::ToOwned, string::String};

/// A fraction p/q in lowest terms: the share of a segment's first end in a point of its line.
///
/// The magnitudes of p, q and q − p are at most [`Share::MOST`], so that doubles and 64-bit integers hold all three.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Share {
    numerator: i64,
    /// Greater than zero.
    denominator: i64,
}

impl Share {
    /// The largest magnitude of the whole numbers p, q and q − p: 2^53.
    pub const MOST: i64 = 1 << 53;

    /// The fraction with this numerator and denominator.
    ///
    /// # Errors
    /// [`ShareError`] if the denominator is zero, or if a whole number of the fraction in lowest terms is too large.
    pub fn new(numerator: i64, denominator: i64) -> Result<Share, ShareError> {
        if denominator == 0 {
            return Err(ShareError::Undefined);
        }
        let [p, q] = [numerator, denominator].map(i128::from);
        let common = greatest_common_divisor(p.unsigned_abs(), q.unsigned_abs()).cast_signed() * q.signum();
        let (p, q) = (p / common, q / common);
        if [p, q, q - p].iter().any(|x| x.unsigned_abs() > u128::from(Share::MOST.unsigned_abs())) {
            return Err(ShareError::TooLong);
        }
        match (i64::try_from(p), i64::try_from(q)) {
            (Ok(numerator), Ok(denominator)) => Ok(Share { numerator, denominator }),
            _ => Err(ShareError::TooLong),
        }
    }

    /// The numerator and the denominator; the denominator is greater than zero.
    #[inline]
    #[must_use]
    pub const fn fraction(self) -> [i64; 2] {
        [self.numerator, self.denominator]
    }

    /// The share of the other end: 1 − α.
    #[inline]
    #[must_use]
    pub const fn rest(self) -> Share {
        Share { numerator: self.denominator - self.numerator, denominator: self.denominator }
    }

    /// The nearest double.
    #[inline]
    #[must_use]
    pub fn nearest(self) -> f64 {
        let [p, q] = self.fraction().map(|x| {
            #[allow(clippy::cast_precision_loss)] // at most 2^53 in magnitude
            let x = x as f64;
            x
        });
        p / q
    }
}

/// The greatest common divisor; `q` is not zero.
fn greatest_common_divisor(mut p: u128, mut q: u128) -> u128 {
    while p != 0 {
        (p, q) = (q % p, p);
    }
    q
}

/// Writes the fraction, as in `1/3` or `-2`.
impl core::fmt::Display for Share {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self.denominator {
            1 => write!(f, "{}", self.numerator),
            denominator => write!(f, "{}/{denominator}", self.numerator),
        }
    }
}

/// The reason why two numbers, or a text, are not a share.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ShareError {
    /// The denominator is zero.
    Undefined,
    /// In lowest terms p/q, one of p, q and q − p is more than [`Share::MOST`] in magnitude.
    TooLong,
    /// The text is not a fraction of whole numbers.
    Text(String),
}

impl core::fmt::Display for ShareError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            ShareError::Undefined => write!(f, "a share has a denominator other than zero"),
            ShareError::TooLong => write!(f, "a share p/q has p, q and q - p of at most 2^53 in magnitude"),
            ShareError::Text(text) => write!(f, "`{text}` is not a fraction such as 1/3"),
        }
    }
}

impl core::error::Error for ShareError {}

/// Reads what `Display` writes; the fraction need not be in lowest terms.
impl core::str::FromStr for Share {
    type Err = ShareError;

    fn from_str(text: &str) -> Result<Share, ShareError> {
        let (numerator, denominator) = text.split_once('/').unwrap_or((text, "1"));
        let whole = |text: &str| {
            // `parse` would accept a leading plus.
            let digits = text.strip_prefix('-').unwrap_or(text);
            let is_plain = digits.bytes().all(|byte| byte.is_ascii_digit());
            text.parse().ok().filter(|_| is_plain)
        };
        match (whole(numerator), whole(denominator)) {
            (Some(numerator), Some(denominator)) => Share::new(numerator, denominator),
            _ => Err(ShareError::Text(text.to_owned())),
        }
    }
}

#[cfg(test)]
mod tests {
    use alloc::string::ToString;

    use super::*;

    #[test]
    fn equal_values_are_equal_shares() {
        let of = |text: &str| text.parse::<Share>().unwrap();
        for (text, fraction) in [
            ("1/3", [1, 3]),
            ("2/6", [1, 3]),
            ("-2/-6", [1, 3]),
            ("2/-6", [-1, 3]),
            ("0/7", [0, 1]),
            ("7", [7, 1]),
            ("-4/2", [-2, 1]),
            ("9007199254740992/9007199254740991", [Share::MOST, Share::MOST - 1]),
        ] {
            assert_eq!(of(text).fraction(), fraction, "{text}");
            assert_eq!(of(&of(text).to_string()), of(text), "{text}");
            assert_eq!(of(text).rest().rest(), of(text), "{text}");
        }
        assert_eq!([of("1/3").rest(), of("-1/2").rest(), of("1").rest()], [of("2/3"), of("3/2"), of("0")]);
        assert_eq!([of("1/4").nearest(), of("-3").nearest(), of("0").nearest()], [0.25, -3.0, 0.0]);
        assert_eq!(Share::new(i64::MIN, i64::MIN).unwrap().fraction(), [1, 1]);
    }

    #[test]
    fn what_is_not_a_share_is_refused_with_the_reason() {
        assert_eq!(Share::new(1, 0), Err(ShareError::Undefined));
        for (p, q) in [(Share::MOST + 1, 1), (1, Share::MOST + 1), (1 - Share::MOST, 2), (i64::MIN, 1)] {
            assert_eq!(Share::new(p, q), Err(ShareError::TooLong), "{p}/{q}");
        }
        for text in ["", "/", "1/", "/3", "0.5", "+1/3", "1/+3", "1 / 3", "1/3/5", "1e3"] {
            assert_eq!(text.parse::<Share>(), Err(ShareError::Text(text.to_owned())), "{text}");
        }
    }
}
