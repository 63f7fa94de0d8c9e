//! The comparison of backends of all philosophies on the same scenes, in one table: when to use which.
//!
//! A suite shows which of its scenes a backend gets wrong. This study asks the same of many random scenes of each kind,
//! for all tasks:
//! * the backend's promise, and the smallest feature that it distinguishes;
//! * the location error of its contacts;
//! * the share of scenes with a broken topology, and the failed checks;
//! * the scenes that it declines;
//! * its time and memory, on general and on degenerate input.
//!
//! * [`Compare`]: the study.
//! * [`Input`]: the scenes, which each task names itself.
//! * [`Measure`]: a number with its interval, a row of `compare.csv`.
//! * [`Standing`]: the results of one backend, independent of the others.
//! * [`Tradeoff`]: errors against time, as data of a plot.
//! * [`Sweep`]: the values of one parameter, and whether one of them can be the default.
//! * [`part`]: the tables and sentences of a page with marks, made from the files of a folder.

mod bits;
pub(crate) mod clock;
mod conditioning;
mod details;
mod errors;
mod inputs;
mod measure;
mod memory;
mod ranking;
mod section;
mod standing;
mod study;
mod survey;
pub(crate) mod sweep;
mod table;
mod tradeoff;
mod tree;
mod which;
mod words;

pub use conditioning::{Conditioned, conditioning};
pub use inputs::{Input, inputs};
pub(crate) use inputs::{asked, compared};
pub use measure::Measure;
pub(crate) use memory::peak;
pub use section::{missing, section};
pub use standing::{
    ASKED_TWICE, BARELY, InputKey, REFERENCE, Ratio, Scenes, Share, Standing, inputs_of, left_out, standings,
    time_ratio,
};
pub use study::{Compare, Compared, Promise};
pub(crate) use survey::{Group, measures_of};
pub use sweep::{Sweep, Value, Verdict, sweeps};
pub(crate) use table::WRONG;
pub use tradeoff::{Tradeoff, tradeoffs};
pub use tree::{Node, decision, decision_tree};
pub use which::part;
pub(crate) use words::short;
