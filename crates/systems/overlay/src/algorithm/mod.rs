//! The algorithms of this crate.
//!
//! * [`overlay`]: arrangements of segments, and Boolean operations on polygons.
//! * [`snap`]: segments and their crossings, rounded to doubles by snap rounding.

pub mod overlay;
pub mod snap;
