//! Answers of a predicate: a sign, or the reason why there is none.

use std::cmp::Ordering;

use predicament_predicates::Sign;

/// The answer of a predicate to one query.
///
/// Closures return anything that converts: `Sign`, `Ordering`, a determinant as `f64` or `f32`, an integer whose sign
/// counts, or an `Option` of these, where `None` means undecided.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Answer {
    /// A sign.
    Sign(Sign),
    /// No sign, and the predicate says so.
    Undecided,
    /// A determinant that is not a number: a comparison with zero takes it for zero.
    NotANumber,
}

impl Answer {
    /// The sign; `None` if there is none.
    #[must_use]
    pub fn sign(self) -> Option<Sign> {
        match self {
            Answer::Sign(sign) => Some(sign),
            Answer::Undecided | Answer::NotANumber => None,
        }
    }

    /// The answer of a predicate with the opposite convention.
    #[must_use]
    pub fn opposite(self) -> Answer {
        match self {
            Answer::Sign(sign) => Answer::Sign(-sign),
            other => other,
        }
    }
}

impl From<Sign> for Answer {
    fn from(sign: Sign) -> Answer {
        Answer::Sign(sign)
    }
}

impl From<Ordering> for Answer {
    fn from(order: Ordering) -> Answer {
        Answer::Sign(order.into())
    }
}

impl From<f64> for Answer {
    fn from(determinant: f64) -> Answer {
        if determinant.is_nan() { Answer::NotANumber } else { Answer::Sign(Sign::of(determinant)) }
    }
}

impl From<f32> for Answer {
    fn from(determinant: f32) -> Answer {
        f64::from(determinant).into()
    }
}

/// Converts integers by their sign.
macro_rules! from_integers {
    ($($integer:ty),+) => {$(
        impl From<$integer> for Answer {
            fn from(determinant: $integer) -> Answer {
                determinant.cmp(&0).into()
            }
        }
    )+};
}

from_integers!(i8, i16, i32, i64, i128, isize);

impl<A: Into<Answer>> From<Option<A>> for Answer {
    fn from(answer: Option<A>) -> Answer {
        answer.map_or(Answer::Undecided, Into::into)
    }
}

impl std::fmt::Display for Answer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Answer::Sign(sign) => write!(f, "{sign}"),
            Answer::Undecided => f.write_str("undecided"),
            Answer::NotANumber => f.write_str("NaN"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_like_a_sign_converts() {
        let negative = Answer::Sign(Sign::Negative);
        let all = [
            Answer::from(-1_i8),
            Answer::from(i32::MIN),
            Answer::from(i64::MIN),
            Answer::from(i128::MIN),
            Answer::from(-f64::MIN_POSITIVE),
            Answer::from(-1.0_f32),
            Answer::from(f64::NEG_INFINITY),
            Answer::from(Ordering::Less),
            Answer::from(Sign::Negative),
            Answer::from(Some(-0.5)),
            Answer::from(Some(Some(Ordering::Less))),
        ];
        assert_eq!(all, [negative; 11]);
        assert_eq!(Answer::from(None::<i32>), Answer::Undecided);
        assert_eq!([Answer::from(f64::NAN), Answer::from(Some(f32::NAN))], [Answer::NotANumber; 2]);
        assert_eq!(Answer::from(-0.0), Answer::Sign(Sign::Zero));
        assert_eq!(negative.opposite(), Answer::from(1));
    }
}
