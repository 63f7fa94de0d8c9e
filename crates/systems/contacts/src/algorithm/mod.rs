//! The algorithms.
//!
//! * [`pairs`]: the pairs of simplices of two complexes that meet.
//! * [`arrangement`]: two complexes merged where they are in contact.
//! * [`thick`]: vertices and edges with a radius, and what overlaps made to coincide.

pub mod arrangement;
pub mod pairs;
pub mod thick;
