//! A fault in claims: the band of every formula is far wider than the calculus allows, and the session says so itself.

use predicament_predicates::{Band, Declined, Derived, PredicateKind, Predicates, Question, Sign, Vertex, forward_to};

use super::Fault;
use super::over::Part;

/// The factor of the claimed bands.
const FACTOR: f64 = 1_073_741_824.0;

/// The tolerances, right except for formulas.
pub(super) struct Boastful;

impl Part for Boastful {
    type Session<'s, P: Predicates + 's> = Session<P>;

    fn around<'s, P: Predicates + 's>(_: Fault, honest: P) -> Session<P> {
        Session(honest)
    }
}

pub(super) struct Session<P>(P);

impl<P: Predicates> Predicates for Session<P> {
    forward_to!(0: scene, predicates);

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        self.0.supports(kind)
    }

    fn sign(&self, predicate: Derived, vertices: &[Vertex]) -> Sign {
        let question = Question::Derived(predicate);
        let width = self.band(question).map_or(0.0, |band| band.width);
        let value = self.0.estimate(question, vertices).unwrap_or(0.0);
        if value.abs() > width { Sign::of(value) } else { Sign::Zero }
    }

    fn band(&self, question: Question) -> Option<Band> {
        let factor = if matches!(question, Question::Derived(_)) { FACTOR } else { 1.0 };
        let Band { lower, width, upper } = self.0.band(question)?;
        Some(Band { lower: factor * lower, width: factor * width, upper: factor * upper })
    }
}
