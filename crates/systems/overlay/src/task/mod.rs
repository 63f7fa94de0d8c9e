//! The tasks `overlay2d` and `snap2d`.

pub mod overlay;
pub mod snap;
