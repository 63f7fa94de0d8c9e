//! When should one use which? Backends of all philosophies on the same scenes, in one table.
//!
//! A suite says which of its scenes a backend gets wrong. Here the same question is asked of many random scenes of each kind, for all tasks:
//! what a backend promises and how small a feature it can tell, how far off it says that things meet, which share of scenes it leaves with a
//! broken topology, and by which check, what it declines, and what it takes in time and memory, on general input and on degenerate one.
//!
//! * [`Compare`]: the study.
//! * [`Input`]: the scenes, which each task names itself.
//! * [`Measure`]: a number with its interval, a row of `compare.csv`.

mod bits;
mod clock;
mod conditioning;
mod errors;
mod inputs;
mod measure;
mod memory;
mod section;
mod study;
mod survey;
mod table;

pub use conditioning::{Conditioned, conditioning};
pub(crate) use inputs::tasks;
pub use inputs::{Input, inputs};
pub use measure::Measure;
pub use section::{missing, section};
pub use study::{Compare, Compared};
pub(crate) use survey::{Group, measures_of};
pub(crate) use table::{WRONG, short};
