//! Unions of congruent cubes measured from their sections, and the measures of random cubes.
//!
//! `crate::algorithm` adds up what vertices contribute. Here
//! nothing knows what a vertex of the union is:
//! * [`measured`]: exactly, from sections, sections of sections, and intervals;
//! * [`Expected`]: what random cubes have on average, by integration.

mod expected;
mod sections;

pub use expected::Expected;
pub use sections::{Measures, measured};
