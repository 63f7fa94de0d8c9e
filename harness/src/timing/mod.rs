//! Timing: preparing backends, taking samples in turns, and timing the parts of algorithms.

pub mod phases;

mod runner;
mod sample;
mod samples;

pub use runner::{Runner, empty, start};
pub use sample::{Limit, sample};
pub use samples::Samples;
