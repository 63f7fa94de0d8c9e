//! The search for worst inputs: how near they come to the bounds of the tolerance paper.
//!
//! A bound that no input comes near is loose, and a bound that an input exceeds is wrong. Random inputs say little
//! about either. So the study searches for inputs: from a random start it changes one thing at a time, and keeps
//! changes that are not worse.
//!
//! * [`errors`]: errors of the values that Algorithms 1 to 12 compute, against exact values.
//! * [`guards`]: the lemmas of 4.3 to 5.7, quantities that are bounded from below if no sub-pair is registered.
//! * [`Worst`]: the study.

mod climb;
mod errors;
mod guards;
mod study;

pub use errors::{Observed, errors};
pub use guards::{Guard, guards};
pub use study::{Found, Worst};
