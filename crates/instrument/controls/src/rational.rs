//! Exact signs the expensive way: every predicate in rational numbers, without a filter.
//!
//! It is the ruler for the ladder of `exact`: both make the same promise, and the ratio of their times is what the
//! ladder saves. Each operation is one of GMP's rationals, by the crate `rug`, and reduces its result to lowest terms.
//! The formulas are those of textbooks. `prepare` makes a rational of each coordinate once, as a program does whose
//! points have rational coordinates.
//!
//! The judge computes in integers over one denominator, by linear equations and Cramer's rule. Nothing here is shared
//! with it, so an error here is found like the error of any backend.

mod determinant;
mod meet;
mod session;

use predicament_predicates::{Backend, Constructs, Contract, Declined, PredicateKind, Scene, Tally, ZeroMeaning};

pub use session::RationalSession;

/// The signs of determinants in rational numbers, constructed vertices included.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub struct ExactRational;

impl Backend for ExactRational {
    type Session<'s, T: Tally + 's> = RationalSession<T>;

    fn name(&self) -> String {
        "exact:rational".to_owned()
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Exact, proved: true }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["rational"]
    }

    fn constructs(&self) -> Constructs {
        Constructs::Keeps
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<RationalSession<T>, Declined> {
        RationalSession::new(scene, tally)
    }

    predicament_predicates::boxed_here!();
}
