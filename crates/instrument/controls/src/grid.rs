//! Snapping to a grid, and then exact signs.

use predicament_predicates::{Backend, Constructs, Contract, Declined, PredicateKind, Scene, Tally, ZeroMeaning};

use crate::determinant::Determinant;
use crate::session::{Float, Session};
use crate::shewchuk::Shewchuk;

/// Each coordinate becomes the nearest multiple of a step, and the signs of these multiples are exact.
///
/// It is right about decimals if the step is that of their digits, and if they are integers below 2^53 in that step. An
/// answer for doubles that are no multiples is about other points, as users of a precision model know.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Grid {
    step: f64,
}

/// The error for a number that is not a valid step.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BadStep(pub f64);

impl std::fmt::Display for BadStep {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} is not a valid step of a grid; it must be a normal positive number", self.0)
    }
}

impl std::error::Error for BadStep {}

impl Grid {
    /// A backend that rounds coordinates to multiples of `step`.
    ///
    /// # Errors
    /// [`BadStep`] if `step` is not normal and positive.
    pub fn new(step: f64) -> Result<Grid, BadStep> {
        if step.is_normal() && step > 0.0 { Ok(Grid { step }) } else { Err(BadStep(step)) }
    }

    /// The number of steps nearest to a coordinate.
    ///
    /// The quotient has a relative error below 2^-52, so that it is nearest to the right integer below 2^51 for
    /// coordinates that are doubles of multiples.
    #[inline]
    fn steps(&self, x: f64) -> f64 {
        (x / self.step).round_ties_even()
    }
}

impl<const D: usize, const N: usize> Determinant<D, N> for Grid
where
    Shewchuk: Determinant<D, N>,
{
    #[inline]
    fn determinant(&self, points: [[f64; D]; N]) -> f64 {
        Shewchuk.determinant(points.map(|point| point.map(|x| self.steps(x))))
    }
}

impl Float for Grid {
    const IN_LANES: bool = false;
    const EVALUATES_FORMULAS: bool = false;
}

impl Backend for Grid {
    type Session<'s, T: Tally + 's> = Session<'s, Grid, T>;

    /// The text `grid:` and the step, which parses back to the same number.
    fn name(&self) -> String {
        format!("grid:{:e}", self.step)
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Exact, proved: false }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["grid"]
    }

    fn constructs(&self) -> Constructs {
        Constructs::Rounds
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Self::Session<'s, T>, Declined> {
        Ok(Session::new(scene, *self, tally))
    }

    predicament_predicates::boxed_here!();
}
