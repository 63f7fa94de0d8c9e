//! The contact algorithms.
//!
//! * [`pairs`]: the pairs of simplices of two complexes that meet.
//! * [`arrangement`]: two complexes, merged at their contacts.
//! * [`thick`]: vertices and edges with a radius; overlapping ones are made to coincide.

pub mod arrangement;
pub mod pairs;
pub mod thick;
