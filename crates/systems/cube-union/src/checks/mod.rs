//! Measures of unions of congruent cubes from their sections, and the expected measures of random cubes.
//!
//! `crate::algorithm` adds up the contributions of vertices. The measures here do not use vertices of the union:
//! * [`measured`]: exact measures, from sections, sections of sections, and intervals;
//! * [`Expected`]: the mean measures of random cubes, by integration.

mod expected;
mod sections;

pub use expected::Expected;
pub use sections::{Measures, Ties, measured, measured_by};
