//! The exact backend: its name, its contract and its stages.

use alloc::{borrow::ToOwned, string::String};
use predicament_predicates::{
    Backend, Batches, Constructs, Contract, Declined, PredicateKind, Scene, Tally, ZeroMeaning,
};

use crate::{Session, stage};

/// The exact backend: it is proved to return the sign of the real determinant.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Exact;

impl Backend for Exact {
    type Session<'s, T: Tally + 's> = Session<'s, T>;

    fn name(&self) -> String {
        "exact".to_owned()
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Exact, proved: true }
    }

    fn stages(&self) -> &'static [&'static str] {
        &stage::NAMES
    }

    fn batches(&self, _: PredicateKind) -> Batches {
        Batches::Own
    }

    fn constructs(&self) -> Constructs {
        Constructs::Keeps
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Session<'s, T>, Declined> {
        Session::new(scene, tally)
    }

    predicament_predicates::boxed_here!();
}
