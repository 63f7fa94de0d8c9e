//! The integration tests, as one binary: each further one would link the crate and compile what they share again.

mod common;
mod judged;
mod overlay;
mod overlay_near;
mod snap;
