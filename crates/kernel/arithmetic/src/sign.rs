//! Signs: the answers to predicates.
//!
//! There are three values and no fourth: a predicate whose arithmetic produced a NaN still has to answer, as real code
//! does.

use core::cmp::Ordering;
use core::ops::{Mul, Neg};

/// The sign of a real number.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
#[repr(i8)]
pub enum Sign {
    /// Less than zero.
    Negative = -1,
    /// Zero, exactly or within a band; the contract of the backend says which.
    #[default]
    Zero = 0,
    /// Greater than zero.
    Positive = 1,
}

impl Sign {
    /// The sign of `x`. NaN gives [`Sign::Zero`], as `x > 0` and `x < 0` are both false.
    #[inline]
    #[must_use]
    pub fn of(x: f64) -> Sign {
        // Without branches: the sign of a random determinant is unpredictable, and a branch misprediction costs more
        // than the determinant.
        match i8::from(x > 0.0) - i8::from(x < 0.0) {
            -1 => Sign::Negative,
            0 => Sign::Zero,
            _ => Sign::Positive,
        }
    }

    /// The sign as -1, 0 or 1.
    #[inline]
    #[must_use]
    pub const fn as_i8(self) -> i8 {
        self as i8
    }

    /// Returns true for [`Sign::Zero`].
    #[inline]
    #[must_use]
    pub const fn is_zero(self) -> bool {
        matches!(self, Sign::Zero)
    }

    /// The symbol `-`, `0` or `+` of the sign in CSV files and reports.
    #[must_use]
    pub const fn symbol(self) -> char {
        match self {
            Sign::Negative => '-',
            Sign::Zero => '0',
            Sign::Positive => '+',
        }
    }

    /// The inverse of [`Sign::symbol`].
    #[must_use]
    pub const fn from_symbol(symbol: char) -> Option<Sign> {
        match symbol {
            '-' => Some(Sign::Negative),
            '0' => Some(Sign::Zero),
            '+' => Some(Sign::Positive),
            _ => None,
        }
    }
}

impl Neg for Sign {
    type Output = Sign;

    #[inline]
    fn neg(self) -> Sign {
        match self {
            Sign::Negative => Sign::Positive,
            Sign::Zero => Sign::Zero,
            Sign::Positive => Sign::Negative,
        }
    }
}

impl Mul for Sign {
    type Output = Sign;

    #[inline]
    fn mul(self, other: Sign) -> Sign {
        match (self, other) {
            (Sign::Zero, _) | (_, Sign::Zero) => Sign::Zero,
            (a, b) if a == b => Sign::Positive,
            _ => Sign::Negative,
        }
    }
}

impl From<Ordering> for Sign {
    #[inline]
    fn from(order: Ordering) -> Sign {
        match order {
            Ordering::Less => Sign::Negative,
            Ordering::Equal => Sign::Zero,
            Ordering::Greater => Sign::Positive,
        }
    }
}

impl core::fmt::Display for Sign {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{}", self.symbol())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_round_trip() {
        for sign in [Sign::Negative, Sign::Zero, Sign::Positive] {
            assert_eq!(Sign::from_symbol(sign.symbol()), Some(sign));
            assert_eq!(-(-sign), sign);
            assert_eq!(sign * Sign::Negative, -sign);
        }
        assert_eq!(Sign::from_symbol('x'), None);
    }

    #[test]
    fn floats_have_the_sign_that_comparisons_see() {
        assert_eq!(Sign::of(-0.0), Sign::Zero);
        assert_eq!(Sign::of(f64::NAN), Sign::Zero);
        assert_eq!(Sign::of(5e-324), Sign::Positive);
        assert_eq!(Sign::of(f64::NEG_INFINITY), Sign::Negative);
    }
}
