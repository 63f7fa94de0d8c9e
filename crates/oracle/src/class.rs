//! The classes that answers fall into (DESIGN's names), and how a sign is classified.
//!
//! An answer is held to two things: the exact sign, and the backend's own
//! promise. Every query is in exactly one class.

use predicament_predicates::{Band, Sign, ZeroMeaning};
use rug::Rational;

use crate::judge::{self, Verdict};

/// What became of a query, or of a whole scene.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Class {
    /// The exact sign.
    Agree,
    /// Exact zero, answered by a sign: promised by backends that break ties.
    TieBroken,
    /// Zero for a value within the upper tolerance: promised by backends with a band.
    InBand,
    /// Zero for a value beyond the upper tolerance; for backends without a band, for any value but zero.
    Overreach,
    /// A degeneracy that the backend promised to report, answered by a sign.
    MissedZero,
    /// The opposite sign.
    SignFlip,
    /// Answers that contradict each other.
    Inconsistent,
    /// The arithmetic produced a NaN.
    Nan,
    /// A topology check failed.
    Topology,
    /// The backend panicked.
    Panic,
    /// The backend took too long.
    Timeout,
    /// The backend said that it can't.
    Declined,
}

impl Class {
    /// All classes, in the order of the columns of `summary.csv`.
    pub const ALL: [Class; 12] = [
        Class::Agree,
        Class::TieBroken,
        Class::InBand,
        Class::Overreach,
        Class::MissedZero,
        Class::SignFlip,
        Class::Inconsistent,
        Class::Nan,
        Class::Topology,
        Class::Panic,
        Class::Timeout,
        Class::Declined,
    ];

    /// The name in files and expectations.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Class::Agree => "agree",
            Class::TieBroken => "tie_broken",
            Class::InBand => "in_band",
            Class::Overreach => "overreach",
            Class::MissedZero => "missed_zero",
            Class::SignFlip => "sign_flip",
            Class::Inconsistent => "inconsistent",
            Class::Nan => "nan",
            Class::Topology => "topology",
            Class::Panic => "panic",
            Class::Timeout => "timeout",
            Class::Declined => "declined",
        }
    }

    /// Whether the class is within a promise. Everything else is a finding
    /// and has to be expected. ([`classify`] hands out `TieBroken` and
    /// `InBand` only to backends that promise them.)
    #[must_use]
    pub const fn is_legal(self) -> bool {
        matches!(self, Class::Agree | Class::TieBroken | Class::InBand)
    }
}

impl std::fmt::Display for Class {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

impl std::str::FromStr for Class {
    type Err = String;

    fn from_str(name: &str) -> Result<Class, String> {
        Class::ALL.into_iter().find(|class| class.name() == name).ok_or_else(|| {
            let names: Vec<&str> = Class::ALL.iter().map(|class| class.name()).collect();
            format!("no class is called `{name}`; the classes are {}", names.join(", "))
        })
    }
}

/// How many of each class.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct ClassCounts([u64; Class::ALL.len()]);

impl ClassCounts {
    /// The count of one class.
    #[must_use]
    pub const fn get(&self, class: Class) -> u64 {
        self.0[class as usize]
    }

    /// Counts `n` more of a class.
    pub const fn add(&mut self, class: Class, n: u64) {
        self.0[class as usize] += n;
    }

    /// Moves `n` from one class to another, as far as there are any.
    pub fn reclassify(&mut self, from: Class, to: Class, n: u64) {
        let n = n.min(self.get(from));
        self.0[from as usize] -= n;
        self.add(to, n);
    }

    /// Adds all counts of another.
    pub fn merge(&mut self, other: &ClassCounts) {
        for (mine, theirs) in self.0.iter_mut().zip(other.0) {
            *mine += theirs;
        }
    }

    /// The sum over all classes that are findings.
    #[must_use]
    pub fn findings(&self) -> u64 {
        Class::ALL.iter().filter(|class| !class.is_legal()).map(|&class| self.get(class)).sum()
    }
}

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

    #[test]
    fn names_are_unique_and_parse() {
        for class in Class::ALL {
            assert_eq!(class.name().parse(), Ok(class));
        }
        assert!("sign-flip".parse::<Class>().unwrap_err().contains("sign_flip"));
    }
}
