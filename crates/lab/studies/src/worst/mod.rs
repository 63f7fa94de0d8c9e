//! How near do the worst inputs come to the bounds of the tolerance paper?
//!
//! A bound that nothing comes near has room, and one that something passes is wrong.
//! Random inputs say little about either. So inputs are searched for: from a random
//! start one thing is changed at a time, and what is no worse is kept.
//!
//! * [`errors`]: errors of what Algorithms 1 to 12 compute, against exact values.
//! * [`guards`]: the lemmas of 4.3 to 5.7, quantities that are bounded from below
//!   where no sub-pair is registered.
//! * [`Worst`]: the study.

mod climb;
mod errors;
mod guards;
mod study;

pub use errors::{Observed, errors};
pub use guards::{Guard, guards};
pub use study::{Found, Worst};
