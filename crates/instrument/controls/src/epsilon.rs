//! Plain floating point with a fixed epsilon.

use predicament_predicates::{
    Backend, Batches, Constructs, Contract, Declined, PredicateKind, Scene, Tally, ZeroMeaning,
};

use crate::determinant::Determinant;
use crate::naive_session::Last;
use crate::session::{Float, Session};

/// Plain f64 determinants, zero if smaller in magnitude than a fixed epsilon, whatever the size of the coordinates.
/// This includes comparisons, whose determinant is the difference.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Epsilon {
    eps: f64,
}

/// The error for a number that is not a valid epsilon.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BadEpsilon(pub f64);

impl std::fmt::Display for BadEpsilon {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} is not a valid epsilon; it must be finite and not negative", self.0)
    }
}

impl std::error::Error for BadEpsilon {}

impl Epsilon {
    /// A backend for which a determinant is zero if its magnitude is less than `eps`, in the units of the determinant.
    /// An `eps` of 0 gives the answers of [`Naive`](crate::Naive).
    ///
    /// # Errors
    /// [`BadEpsilon`] if `eps` is NaN, infinite or negative.
    pub fn new(eps: f64) -> Result<Epsilon, BadEpsilon> {
        if eps.is_finite() && eps >= 0.0 {
            // −0 becomes 0, also in the name.
            Ok(Epsilon { eps: eps.abs() })
        } else {
            Err(BadEpsilon(eps))
        }
    }

    /// The threshold below which a determinant is zero.
    #[must_use]
    pub fn eps(&self) -> f64 {
        self.eps
    }
}

impl Default for Epsilon {
    /// The threshold 1e-10, a constant common in programs.
    fn default() -> Epsilon {
        Epsilon { eps: 1e-10 }
    }
}

impl<const D: usize, const N: usize> Determinant<D, N> for Epsilon
where
    Last: Determinant<D, N>,
{
    #[inline(always)]
    fn determinant(&self, points: [[f64; D]; N]) -> f64 {
        Last.determinant(points)
    }
}

impl Float for Epsilon {
    const IN_LANES: bool = true;

    #[inline(always)]
    fn value(&self, determinant: f64) -> f64 {
        // A selected zero instead of a branch, because small determinants are not predictable.
        if determinant.abs() < self.eps { 0.0 } else { determinant }
    }
}

impl Backend for Epsilon {
    type Session<'s, T: Tally + 's> = Session<'s, Epsilon, T>;

    /// The text `epsilon:` and the threshold, which parses back to the same number.
    fn name(&self) -> String {
        format!("epsilon:{:e}", self.eps)
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Exact, proved: false }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["float"]
    }

    fn batches(&self, _: PredicateKind) -> Batches {
        Batches::Own
    }

    fn constructs(&self) -> Constructs {
        Constructs::Rounds
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Self::Session<'s, T>, Declined> {
        Ok(Session::new(scene, *self, tally))
    }

    predicament_predicates::boxed_here!();
}
