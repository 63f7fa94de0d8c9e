//! A step of a cascade, and what is told of it.

use std::time::Duration;

use predicament_judge::rational;
use predicament_overlay::checks::overlay::Shape;
use predicament_tasks::Stop;

use super::cascade::Loop;
use super::contradiction::Contradiction;

/// Why a method does not go on.
pub(super) enum End {
    Stopped(Stop),
    Failed(String),
}

/// A step that fails ends the method, which says why.
impl<E: std::error::Error> From<E> for End {
    fn from(why: E) -> End {
        End::Failed(why.to_string())
    }
}

/// A step that was done.
pub(super) struct Stepped<'a> {
    pub elapsed: Duration,
    pub constructed: usize,
    pub collapsed: usize,
    pub held: usize,
    pub thickness: f64,
    pub broken: Option<Contradiction>,
    /// Whether nothing is left.
    pub is_gone: bool,
    pub shape: &'a dyn Fn() -> Shape,
    pub turned: &'a dyn Fn() -> Option<usize>,
}

/// The steps to measure, and the function that takes each measurement.
pub(super) struct Then<'t> {
    pub samples: &'t [usize],
    pub note: &'t mut dyn FnMut(Stepped<'_>) -> Result<(), End>,
}

impl Then<'_> {
    /// Whether the step with this place, from 0, is measured.
    pub fn is_sampled(&self, at: usize) -> bool {
        self.samples.binary_search(&(at + 1)).is_ok()
    }

    /// Tells of a step.
    pub fn call(&mut self, stepped: Stepped<'_>) -> Result<(), End> {
        (self.note)(stepped)
    }
}

/// Loops of doubles, exactly; a coordinate that is not finite is 0.
pub(super) fn shape_of(regions: &[Vec<Loop>]) -> Shape {
    let exactly = |x: f64| if x.is_finite() { rational(x) } else { rational(0.0) };
    let one = |one: &Loop| one.iter().map(|corner| corner.map(exactly)).collect();
    Shape { regions: regions.iter().map(|region| region.iter().map(one).collect()).collect() }
}
