//! The integration tests, as one binary: more binaries would link the crate and compile shared code again.

mod common;
mod judged;
mod memory;
mod overlay;
mod overlay_lies;
mod overlay_near;
mod overlay_parts;
mod snap;
mod threads;
