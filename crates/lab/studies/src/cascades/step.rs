//! A step of a cascade, and its report.

use std::time::Duration;

use predicament_judge::rational;
use predicament_overlay::checks::overlay::Shape;
use predicament_tasks::Stop;

use super::cascade::Loop;
use super::contradiction::Contradiction;

/// The reason why a method stops.
pub(super) enum End {
    Stopped(Stop),
    Failed(String),
}

/// A step that fails ends the method, with its error as the reason.
impl<E: std::error::Error> From<E> for End {
    fn from(why: E) -> End {
        End::Failed(why.to_string())
    }
}

/// The result of a step.
pub(super) struct Stepped<'a> {
    pub elapsed: Duration,
    pub constructed: usize,
    pub collapsed: usize,
    pub held: usize,
    pub thickness: f64,
    pub broken: Option<Contradiction>,
    /// True if the result is empty.
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
    /// Returns true if the step with this index, from 0, is measured.
    pub fn is_sampled(&self, at: usize) -> bool {
        self.samples.binary_search(&(at + 1)).is_ok()
    }

    /// Reports a step.
    pub fn call(&mut self, stepped: Stepped<'_>) -> Result<(), End> {
        (self.note)(stepped)
    }
}

/// The exact shape of loops of doubles; a coordinate that is not finite is 0.
pub(super) fn shape_of(regions: &[Vec<Loop>]) -> Shape {
    let exactly = |x: f64| if x.is_finite() { rational(x) } else { rational(0.0) };
    let one = |one: &Loop| one.iter().map(|corner| corner.map(exactly)).collect();
    Shape { regions: regions.iter().map(|region| region.iter().map(one).collect()).collect() }
}
