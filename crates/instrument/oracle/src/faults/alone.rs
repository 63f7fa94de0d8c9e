//! A fault of ties on the sphere: each is broken by the order of its own vertices, not as part of one perturbed scene.

use predicament_predicates::{Declined, Derived, PredicateKind, Predicates, Sign, Vertex, forward_to};

use super::Fault;
use super::over::Part;

/// SoS, right except for determinants of directions: never zero and antisymmetric, but not consistent.
pub(super) struct Alone;

impl Part for Alone {
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
        let is_tie = predicate.with_points(self.scene(), vertices, |points| {
            predicate.formula().sign(points).is_some_and(std::cmp::Ordering::is_eq)
        });
        if !is_tie || !predicate.formula().is_determinant() {
            return self.0.sign(predicate, vertices);
        }
        let later = |at: usize| vertices[..at].iter().filter(|v| v.index() > vertices[at].index()).count();
        let is_odd = (0..vertices.len()).map(later).sum::<usize>() % 2 == 1;
        if is_odd { Sign::Negative } else { Sign::Positive }
    }
}
