//! The laws that answers must satisfy.
//!
//! * [`overlay`]: for arrangements of segments, and Boolean operations on polygons.
//! * [`snap`]: for drawings rounded to pixels.

pub mod overlay;
pub mod snap;
