//! The algorithms.
//!
//! * [`overlay`]: arrangements of segments, and Boolean operations on polygons.
//! * [`snap`]: segments and their crossings brought back to doubles by snap rounding.

pub mod overlay;
pub mod snap;
