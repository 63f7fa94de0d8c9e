//! The values that the constants must exceed, in rationals: the proofs, step by step.

use rug::{Rational, ops::Pow};

use super::UNIT_ROUNDOFF;

/// The roundings of one predicate, and the bound that they prove.
#[derive(Clone, Copy)]
pub struct Requirement {
    /// The maximum of |x + y|/P over all inputs with a wrong sign.
    wrong: fn() -> Rational,
    /// The roundings of a term of the permanent, counted from the point where P is taken.
    permanent: u32,
    /// The number of differences of a term, if P is the permanent of the coordinates as given.
    ///
    /// `None` if P is the permanent of differences already rounded.
    degree: u32,
}

/// The requirements of the determinants, in the order of `PredicateKind::DETERMINANTS`.
pub const REQUIREMENTS: [Requirement; 4] = [
    Requirement { wrong: || errors(3), permanent: 4, degree: 2 },
    Requirement { wrong: || half_a_sum(6), permanent: 8, degree: 3 },
    Requirement { wrong: incircle, permanent: 7, degree: 0 },
    Requirement { wrong: || errors(15), permanent: 16, degree: 5 },
];

impl Requirement {
    /// The value that B must exceed for |d| ≥ fl(B·p) to be a proof.
    pub fn semi_static(self) -> Rational {
        last_roundings((self.wrong)()) / down(self.permanent)
    }

    /// The least B for which |d| ≥ B·M is a proof.
    ///
    /// M is the largest permanent, by extents that may have been rounded to nearest, downwards.
    pub fn fixed_scene(self) -> Rational {
        (self.wrong)() * up(1) / down(self.degree)
    }
}

/// The requirement for n roundings before the last sum and m in the permanent.
pub fn counted(n: u32, m: u32) -> Rational {
    last_roundings(errors(n)) / down(m)
}

/// The largest d for this x + y, over the smallest fl(B·p) for that d.
fn last_roundings(wrong: Rational) -> Rational {
    wrong * up(1) / down(1)
}

fn u() -> Rational {
    Rational::from_f64(UNIT_ROUNDOFF).expect("finite")
}

/// The factor (1 + u)^n.
fn up(n: u32) -> Rational {
    let base: Rational = u() + 1;
    base.pow(n)
}

/// The factor (1 − u)^n.
fn down(n: u32) -> Rational {
    let base: Rational = 1 - u();
    base.pow(n)
}

/// The error of n roundings of every term, over P.
fn errors(n: u32) -> Rational {
    up(n) - 1
}

/// The largest wrong |x + y|/P for (t₁ + t₂) + t₃ with n roundings before the first sum s.
///
/// A wrong sign means |x + y| ≤ e·P + u|s| =: E with e = (1 + u)^n − 1. From (1 − u)|s| ≤ |x| ≤ |t₃| + E and |s| + |t₃|
/// ≤ (1 + u)^n·P follows (2 − 2u)|s| ≤ ((1 + u)^n + e)·P.
fn half_a_sum(n: u32) -> Rational {
    let sum = (up(n) + errors(n)) / (Rational::from(2) - 2 * u());
    errors(n) + u() * sum
}

/// The largest wrong |x + y|/P for incircle, with P of the rounded differences.
///
/// Let D′ be the determinant of the rounded differences. After the differences, 5 roundings and a first sum follow, as
/// for orient3d. Before, each difference is its rounded self times 1 + η with |η| ≤ h = u/(1 − u). So by the lemma of
/// `docs/FILTERS.md` |D − D′| ≤ h·(3P + 14|D′|) + (terms of second order in h). A wrong sign means |D| ≤ E, and so |D′|
/// ≤ E + |D − D′|, for which a crude bound suffices first.
fn incircle() -> Rational {
    let h = u() / down(1);
    let h4: Rational = Rational::from(1 + &h).pow(4) - Rational::from(1);
    let beyond = h4.clone() - 4 * h.clone();
    // Every term sees 5 roundings, one more of u|s| with |s| ≤ (1 + u)^5·P, and its differences.
    let crude = errors(5) + u() * up(5) + &h4;
    let moved = crude.clone() + h4;
    // (1 − u)|s| ≤ |t₃| + E and |s| + |t₃| ≤ (1 + u)^5·P.
    let sum = (up(5) + crude) / (Rational::from(2) - u());
    errors(5) + u() * sum + h * (3 + 14 * moved) + beyond
}
