//! The oracle: runs backends on scenes, classifies their answers, measures error.
//!
//! * [`Case`]: a loaded scene with the truth about it; [`Case::run`] holds one
//!   backend against it and gives an [`Outcome`].
//! * [`classify`]: what becomes of an answer; [`expect`]: which findings are expected.
//! * [`audit`]: the tolerance paper's algorithms at their thresholds, one by one.
//! * [`parity`]: closed curves that cross an odd number of times, by search; [`shrink`]: the smallest of them.
//! * [`laws`]: the laws of predicates on tuples by the million.
//! * [`resolution`]: what tolerances cost in resolution.
//! * [`roster`]: all backends by name; [`faults`]: wrong ones that have to be caught.

pub mod audit;
pub mod contacts;
pub mod cubes;
pub mod expect;
pub mod faults;
pub mod interval;
pub mod laws;
pub mod locate;
pub mod parity;
pub mod resolution;
pub mod roster;
pub mod shrink;
pub mod signs;

mod axioms;
mod case;
mod class;
mod contestant;
mod error;
mod outcome;
mod prepared;
mod watch;
#[cfg(feature = "peers")]
mod wild;

pub use case::{Case, Dispute, Truth};
pub use class::{ClassCounts, classify};
pub use contestant::{Contestant, Entry, Explanation, Stopwatch, digest_of};
pub use outcome::{Finding, LocateCounts, MassCounts, Outcome, finding_id};
pub use predicament_predicates::{Class, Status};
pub use watch::{Stop, Watch};

/// The example in the documentation of backends has to compile.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/BACKENDS.md")]
struct Backends;
