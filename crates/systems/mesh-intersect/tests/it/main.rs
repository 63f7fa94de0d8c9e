//! The integration tests, as one binary: more binaries would link the crate and compile shared code again.

mod common;
mod mesh_laws;
mod mesh_limit;
mod mesh_overlay;
mod mesh_overlay_registered;
mod mesh_overlay_same;
mod mesh_overlay_signs;
mod mesh_resolve;
mod mesh_rounding;
