//! Predicates in plain floating point.

use predicament_predicates::{
    Backend, Batches, Constructs, Contract, Declined, PredicateKind, Scene, Tally, ZeroMeaning,
};

use crate::determinant::Pivot;
use crate::naive_session::NaiveSession;

/// The signs of plain f64 determinants.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub struct Naive {
    /// The point that is subtracted first.
    pub pivot: Pivot,
}

impl Backend for Naive {
    type Session<'s, T: Tally + 's> = NaiveSession<'s, T>;

    /// The name `naive`, `naive:first` or `naive:nalgebra`.
    fn name(&self) -> String {
        match self.pivot {
            Pivot::Last => "naive",
            Pivot::First => "naive:first",
            Pivot::Homogeneous => "naive:nalgebra",
        }
        .to_owned()
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Exact, proved: false }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["float"]
    }

    fn batches(&self, _: PredicateKind) -> Batches {
        match self.pivot {
            Pivot::Last | Pivot::First => Batches::Own,
            Pivot::Homogeneous => Batches::Loop,
        }
    }

    fn constructs(&self) -> Constructs {
        Constructs::Rounds
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Self::Session<'s, T>, Declined> {
        Ok(NaiveSession::new(scene, self.pivot, tally))
    }

    predicament_predicates::boxed_here!();
}
