//! The study of decimals: which backend is right about the numbers that were written?
//!
//! Users type decimals and get doubles. Exact signs of the doubles are right about the doubles, and mostly wrong about
//! points that were written on a line. A tolerance, an epsilon or a grid may be right about what was meant, and wrong
//! about what was not. The study counts both, by the number of digits, the distance from the origin and the figure.
//!
//! * [`Decimals`]: the study. [`Answered`]: a row of its file.
//! * [`sources`]: the table by the source of the data, for the page "which backend for what".

mod plots;
mod row;
mod sources;
mod study;
mod survey;
mod table;

pub use row::{Answered, Timed};
pub use sources::sources;
pub use study::Decimals;

/// The file of rows.
pub const FILE: &str = "decimals.csv";
