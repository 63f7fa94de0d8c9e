//! The parts of an algorithm, timed one by one.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// What a phase took, for all that it counts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Phase {
    /// Its name: `grid`, `queries`, …
    pub name: &'static str,
    /// What is counted: `triangle`, `query`, …
    pub unit: &'static str,
    /// How many of them there are.
    pub count: usize,
    /// The time of all of them.
    pub elapsed: Duration,
    /// The memory of what was made, in bytes; none where that is not known.
    pub bytes: Option<usize>,
}

impl Phase {
    /// Times the making of something, and hands it over.
    pub fn timed<T>(name: &'static str, unit: &'static str, count: usize, make: impl FnOnce() -> T) -> (Phase, T) {
        let start = Instant::now();
        let made = black_box(make());
        (Phase { name, unit, count, elapsed: start.elapsed(), bytes: None }, made)
    }

    /// The phase with the memory of what was made.
    #[must_use]
    pub fn with_bytes(self, bytes: usize) -> Phase {
        Phase { bytes: Some(bytes), ..self }
    }
}
