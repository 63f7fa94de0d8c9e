//! The integration tests, as one binary: more binaries would link the crate and compile shared code again.

mod pieces;
mod triangulate;
mod triangulation;
