//! The integration tests, as one binary: each further binary would link the crate and compile shared code again.

mod box_index;
mod cells;
mod columns;
mod raster;
mod shared;
mod sort;
mod two_level;
