//! The crate `axiolid-predicates`: a filter, then expansions, and an answer with a flag for certainty.
//!
//! Its conventions are ours. According to its documentation, the exact predicates are always certain for finite
//! coordinates; an uncertain answer is declined.

use axiolid_guarantees::{Certified, Sign};
use predicament_engine::{Answer, Engine, Predicate, Vertex, Zero, locked, serve};

#[derive(Default)]
struct Axiolid;

impl Engine for Axiolid {
    const NAME: &'static str = "axiolid";
    const ZERO: Zero = Zero::Exact;
    const PREDICATES: &'static [Predicate] =
        &[Predicate::Orient2d, Predicate::Orient3d, Predicate::Incircle, Predicate::Insphere];

    fn version() -> String {
        locked(include_str!("Cargo.lock"), "axiolid-predicates")
    }

    fn orient2d(&self, points: [Vertex<2>; 3]) -> Answer {
        let [a, b, c] = points.map(|point| point.at.into());
        sign(axiolid_predicates::orient2d(a, b, c))
    }

    fn orient3d(&self, points: [Vertex<3>; 4]) -> Answer {
        let [a, b, c, d] = points.map(|point| point.at.into());
        sign(axiolid_predicates::orient3d(a, b, c, d))
    }

    fn incircle(&self, points: [Vertex<2>; 4]) -> Answer {
        let [a, b, c, d] = points.map(|point| point.at.into());
        sign(axiolid_predicates::incircle(a, b, c, d))
    }

    fn insphere(&self, points: [Vertex<3>; 5]) -> Answer {
        let [a, b, c, d, e] = points.map(|point| point.at.into());
        sign(axiolid_predicates::insphere(a, b, c, d, e))
    }
}

fn sign(answer: Certified) -> Answer {
    match answer.sign() {
        Some(Sign::Negative) => Answer::Negative,
        Some(Sign::Zero) => Answer::Zero,
        Some(Sign::Positive) => Answer::Positive,
        // Uncertain, or a sign that this version does not have yet.
        _ => Answer::Declined,
    }
}

fn main() -> std::process::ExitCode {
    serve::<Axiolid>()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Scenes are finite, so only a point from outside of any scene shows it.
    #[test]
    fn an_answer_without_a_certificate_is_declined() {
        let points = [0.0, 1.0, 2.0, f64::NAN].map(|x| Vertex { at: [x, x * x, 1.0], id: 0 });
        assert_eq!(Axiolid.orient3d(points), Answer::Declined);
    }
}
