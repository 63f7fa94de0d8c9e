//! A faulty backend over an honest one: the honest one's sessions, with one part wrong.

use std::marker::PhantomData;

use predicament_predicates::{Backend, Contract, Declined, Off, PredicateKind, Predicates, Scene, Tally};

use super::Fault;

/// A part that is wrong.
pub(super) trait Part: Send + Sync + 'static {
    /// The session around an honest one.
    type Session<'s, P: Predicates + 's>: Predicates + 's;

    /// The honest session with this part wrong.
    fn around<'s, P: Predicates + 's>(fault: Fault, honest: P) -> Self::Session<'s, P>;
}

/// The honest backend with one part wrong.
pub(super) struct Over<B, W> {
    fault: Fault,
    honest: B,
    wrong: PhantomData<fn() -> W>,
}

impl<B, W: Part> Over<B, W> {
    pub(super) fn new(fault: Fault, honest: B, _: W) -> Self {
        Over { fault, honest, wrong: PhantomData }
    }
}

impl<B: Backend, W: Part> Backend for Over<B, W> {
    type Session<'s, T: Tally + 's>
        = W::Session<'s, B::Session<'s, Off>>
    where
        B: 's;

    fn name(&self) -> String {
        format!("fault:{}", self.fault.name())
    }

    fn contract(&self, kind: PredicateKind) -> Contract {
        Contract { proved: false, ..self.honest.contract(kind) }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["faulty"]
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, _: T) -> Result<Self::Session<'s, T>, Declined> {
        Ok(W::around(self.fault, self.honest.prepare(scene, Off)?))
    }
}
