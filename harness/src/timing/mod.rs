//! Timing: backends at their starting lines, samples in turns, and the parts of algorithms one by one.

pub mod phases;

mod runner;
mod sample;
mod samples;

pub use runner::{Runner, empty, start};
pub use sample::{Limit, sample};
pub use samples::Samples;
