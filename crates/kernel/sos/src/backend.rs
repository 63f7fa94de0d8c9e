//! The backend: its names, its contract and its stages.

use predicament_predicates::{
    Backend, Batches, Constructs, Contract, Declined, PredicateKind, Scene, Tally, ZeroMeaning,
};

use crate::breaker::Breaker;
use crate::{Scheme, Session, stage};

/// The Simulation of Simplicity backend.
///
/// Its promise is proved: the sign of the real determinant if that is not zero. Otherwise the answer is the sign, for
/// all small enough ε > 0, of the determinant of the scene that the scheme has moved. Between input vertices the answer
/// is zero only if a vertex occurs twice in a query. About constructed vertices it is zero exactly if the determinant
/// is zero wherever the input vertices are.
///
/// [`Scheme::PerCoordinate`] moves constructed vertices with the vertices that define them. The other scheme declines
/// scenes with constructed vertices, and this one declines scenes whose definitions name constructed vertices.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct Sos {
    /// The perturbation scheme.
    pub scheme: Scheme,
}

impl Backend for Sos {
    type Session<'s, T: Tally + 's> = Session<'s, T>;

    /// The name `sos`, and the scheme if it is not the default.
    fn name(&self) -> String {
        match self.scheme {
            Scheme::PerCoordinate => "sos".to_owned(),
            Scheme::EdelsbrunnerMucke => format!("sos:{}", self.scheme),
        }
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Never, proved: true }
    }

    /// The exact backend's stages, then `term 1`, `term 2`… for ties.
    ///
    /// The number is the position of the deciding term in the predicate's list.
    fn stages(&self) -> &'static [&'static str] {
        stage::names(self.scheme)
    }

    fn batches(&self, _: PredicateKind) -> Batches {
        Batches::Own
    }

    fn constructs(&self) -> Constructs {
        match self.scheme {
            Scheme::PerCoordinate => Constructs::KeepsFirst,
            Scheme::EdelsbrunnerMucke => Constructs::Declines,
        }
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Session<'s, T>, Declined> {
        Ok(Session::new(Breaker::new(self.scheme, scene)?, tally))
    }

    predicament_predicates::boxed_here!();
}
