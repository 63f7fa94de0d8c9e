//! The integration tests, as one binary: each further one would link the crate and compile what they share again.

mod box_index;
mod cells;
mod columns;
mod raster;
mod shared;
mod sort;
mod two_level;
