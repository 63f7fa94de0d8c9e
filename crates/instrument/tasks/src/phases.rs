//! Timings of the parts of an algorithm.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// The timing of one phase, for all its items.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Phase {
    /// Its name: `grid`, `queries`, …
    pub name: &'static str,
    /// The counted unit: `triangle`, `query`, …
    pub unit: &'static str,
    /// The number of units.
    pub count: usize,
    /// The total time.
    pub elapsed: Duration,
    /// The memory of the result, in bytes; `None` if it is not known.
    pub bytes: Option<usize>,
}

impl Phase {
    /// Times a computation, and returns its result with the phase.
    pub fn timed<T>(name: &'static str, unit: &'static str, count: usize, make: impl FnOnce() -> T) -> (Phase, T) {
        let start = Instant::now();
        let made = black_box(make());
        (Phase { name, unit, count, elapsed: start.elapsed(), bytes: None }, made)
    }

    /// The phase with the memory of its result.
    #[must_use]
    pub fn with_bytes(self, bytes: usize) -> Phase {
        Phase { bytes: Some(bytes), ..self }
    }
}
