//! The integration tests, as one binary: each further one would link the crate and compile what they share again.

mod common;
mod polygon_locate;
mod polygon_shapes;
mod polygon_special;
mod tiling;
