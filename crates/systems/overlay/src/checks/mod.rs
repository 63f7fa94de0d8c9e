//! The laws that answers must satisfy.
//!
//! * [`overlay`]: for arrangements of segments, and Boolean operations on polygons.
//! * [`replies`]: for Boolean operations of other programs, in doubles.
//! * [`snap`]: for drawings rounded to pixels.
//! * [`snap_replies`]: for drawings that other programs round to a grid.

pub mod overlay;
pub mod replies;
pub mod snap;
pub mod snap_replies;
