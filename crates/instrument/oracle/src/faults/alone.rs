//! A fault of ties on the sphere: each is broken by the order of its own vertices, not as part of one perturbed scene.

use predicament_predicates::{
    Backend, Contract, Declined, Derived, Off, PredicateKind, Predicates, Scene, Sign, Tally, Vertex, forward_to,
};
use predicament_sos::Sos;

use super::Fault;

/// SoS, right except for determinants of directions: never zero and antisymmetric, but not consistent.
pub(super) struct Alone;

impl Backend for Alone {
    type Session<'s, T: Tally + 's> = Session<<Sos as Backend>::Session<'s, Off>>;

    fn name(&self) -> String {
        format!("fault:{}", Fault::SosAloneOnSphere.name())
    }

    fn contract(&self, kind: PredicateKind) -> Contract {
        Contract { proved: false, ..Sos::default().contract(kind) }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["faulty"]
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, _: T) -> Result<Self::Session<'s, T>, Declined> {
        const HONEST: &Sos = &Sos { scheme: predicament_sos::Scheme::PerCoordinate };
        HONEST.prepare(scene, Off).map(Session)
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
