//! How a sign is classified.
//!
//! An answer is held to two things: the exact sign, and the backend's own
//! promise. Every query is in exactly one class.

use predicament_predicates::{Band, Class, Sign, ZeroMeaning};

/// Classifies one answer. `is_within` tells whether the determinant is at most so large in magnitude; it is asked only
/// where that matters (backends with a band).
#[must_use]
pub fn classify(
    zero: ZeroMeaning,
    band: Option<Band>,
    answer: Sign,
    truth: Sign,
    is_within: impl FnOnce(f64) -> bool,
) -> Class {
    match (answer, truth) {
        (Sign::Zero, Sign::Zero) => match zero {
            ZeroMeaning::Never => Class::Inconsistent,
            ZeroMeaning::Exact | ZeroMeaning::Band => Class::Agree,
        },
        (Sign::Zero, _) => match band {
            Some(band) if is_within(band.upper) => Class::InBand,
            _ => Class::Overreach,
        },
        (_, Sign::Zero) => match zero {
            ZeroMeaning::Never => Class::TieBroken,
            ZeroMeaning::Exact | ZeroMeaning::Band => Class::MissedZero,
        },
        (answer, truth) if answer != truth => Class::SignFlip,
        _ => match band {
            Some(band) if is_within(band.lower) => Class::MissedZero,
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
        classify(zero, band, answer, Sign::of(determinant), |limit| determinant.abs() <= limit)
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
