//! The integration tests, as one binary: more binaries would link the crate and compile shared code again.

mod common;
mod polygon_locate;
mod polygon_shapes;
mod polygon_special;
mod tiling;
