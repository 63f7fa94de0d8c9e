//! Unions of congruent cubes, measured another way.
//!
//! `predicament_algorithms::cube_union` adds up what vertices contribute. Here
//! nothing knows what a vertex of the union is:
//! * [`measured`]: exactly, from sections, sections of sections, and intervals;
//! * [`Expected`]: what random cubes have on average, by integration.

mod expected;
mod sections;

pub use expected::Expected;
pub use sections::{Measures, measured};
