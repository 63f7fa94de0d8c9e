//! `axiolid-predicates`: a filter, then expansions, and an answer that says whether it is proved.
//!
//! Its conventions are ours: all four are the signs of the determinants. Every call ends in
//! `Certified`. Its documentation says that the exact predicates are always certain for finite coordinates;
//! an answer that is not certain is none, and is thrown as one that was declined.

use axiolid_guarantees::{Certified, Sign as Theirs};
use predicament_predicates::{Broken, Class, PredicateKind, Sign, ZeroMeaning};

use super::{Library, Point};

/// The crate `axiolid-predicates`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Axiolid;

impl Axiolid {
    /// The sign that the crate certifies.
    ///
    /// # Panics
    /// Throws [`Broken`] where it certifies none.
    #[must_use]
    pub fn sign(answer: Certified) -> Sign {
        match answer.sign() {
            Some(Theirs::Negative) => Sign::Negative,
            Some(Theirs::Zero) => Sign::Zero,
            Some(Theirs::Positive) => Sign::Positive,
            // Uncertain, or a sign that this version does not have yet.
            _ => Broken { class: Class::Declined, check: "certificate", message: format!("{answer:?}") }.throw(),
        }
    }
}

impl Library for Axiolid {
    fn name(&self) -> &'static str {
        "axiolid"
    }

    fn zero(&self, kind: PredicateKind) -> Option<ZeroMeaning> {
        (kind != PredicateKind::Compare).then_some(ZeroMeaning::Exact)
    }

    fn orient2d(&self, points: [Point<2>; 3]) -> Sign {
        let [a, b, c] = points.map(|point| point.at.into());
        Axiolid::sign(axiolid_predicates::orient2d(a, b, c))
    }

    fn orient3d(&self, points: [Point<3>; 4]) -> Sign {
        let [a, b, c, d] = points.map(|point| point.at.into());
        Axiolid::sign(axiolid_predicates::orient3d(a, b, c, d))
    }

    fn incircle(&self, points: [Point<2>; 4]) -> Sign {
        let [a, b, c, d] = points.map(|point| point.at.into());
        Axiolid::sign(axiolid_predicates::incircle(a, b, c, d))
    }

    fn insphere(&self, points: [Point<3>; 5]) -> Sign {
        let [a, b, c, d, e] = points.map(|point| point.at.into());
        Axiolid::sign(axiolid_predicates::insphere(a, b, c, d, e))
    }
}
