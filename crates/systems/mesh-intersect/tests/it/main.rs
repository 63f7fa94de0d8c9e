//! The integration tests, as one binary: each further one would link the crate and compile what they share again.

mod common;
mod mesh_limit;
mod mesh_overlay;
mod mesh_overlay_registered;
mod mesh_overlay_same;
mod mesh_overlay_signs;
mod mesh_resolve;
mod mesh_rounding;
