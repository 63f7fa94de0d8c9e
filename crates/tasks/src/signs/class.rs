//! How a sign is classified.
//!
//! An answer is held to two things: the exact sign, and the backend's own
//! promise. Every query is in exactly one class.

use predicament_predicates::{Band, Class, Sign, ZeroMeaning};
use rug::Rational;

use predicament_judge::{self as judge, Verdict};

/// Classifies one answer. `verdict` is asked for only where the size of the
/// determinant matters (backends with a band).
#[must_use]
pub fn classify(
    zero: ZeroMeaning,
    band: Option<Band>,
    answer: Sign,
    truth: Sign,
    verdict: impl FnOnce() -> Verdict,
) -> Class {
    let within = |limit: f64, verdict: Verdict| Rational::from(verdict.determinant.abs_ref()) <= judge::rational(limit);
    match (answer, truth) {
        (Sign::Zero, Sign::Zero) => match zero {
            ZeroMeaning::Never => Class::Inconsistent,
            ZeroMeaning::Exact | ZeroMeaning::Band => Class::Agree,
        },
        (Sign::Zero, _) => match band {
            Some(band) if within(band.upper, verdict()) => Class::InBand,
            _ => Class::Overreach,
        },
        (_, Sign::Zero) => match zero {
            ZeroMeaning::Never => Class::TieBroken,
            ZeroMeaning::Exact | ZeroMeaning::Band => Class::MissedZero,
        },
        (answer, truth) if answer != truth => Class::SignFlip,
        _ => match band {
            Some(band) if within(band.lower, verdict()) => Class::MissedZero,
            _ => Class::Agree,
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Sign::{Negative, Positive, Zero};

    const BAND: Option<Band> = Some(Band { lower: 1.0, width: 2.0, upper: 3.0 });

    fn of(zero: ZeroMeaning, band: Option<Band>, answer: Sign, determinant: f64) -> Class {
        let verdict = Verdict { determinant: judge::rational(determinant), permanent: judge::rational(10.0) };
        classify(zero, band, answer, Sign::of(determinant), || verdict)
    }

    #[test]
    fn each_promise_has_its_own_legal_disagreement() {
        use ZeroMeaning::{Band as InBand, Exact, Never};
        assert_eq!(of(Exact, None, Zero, 0.0), Class::Agree);
        assert_eq!(of(Never, None, Zero, 0.0), Class::Inconsistent);
        assert_eq!(of(Exact, None, Positive, 0.0), Class::MissedZero);
        assert_eq!(of(Never, None, Positive, 0.0), Class::TieBroken);
        assert_eq!(of(InBand, BAND, Positive, 0.0), Class::MissedZero);
        assert_eq!(of(Exact, None, Zero, 0.5), Class::Overreach);
        assert_eq!(of(Never, None, Zero, -0.5), Class::Overreach);
        for zero in [Exact, Never, InBand] {
            assert_eq!(of(zero, None, Positive, -5.0), Class::SignFlip);
            assert_eq!(of(zero, None, Negative, -5.0), Class::Agree);
        }
    }

    #[test]
    fn a_band_is_held_to_both_of_its_edges() {
        let of = |answer, determinant| of(ZeroMeaning::Band, BAND, answer, determinant);
        assert_eq!(of(Zero, 3.0), Class::InBand);
        assert_eq!(of(Zero, -3.000_001), Class::Overreach);
        assert_eq!(of(Positive, 1.000_001), Class::Agree);
        assert_eq!(of(Positive, 1.0), Class::MissedZero);
        assert_eq!(of(Negative, 1.0), Class::SignFlip);
    }
}
