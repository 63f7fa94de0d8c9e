//! Broad phases: from raw coordinates alone, the few features that predicates have to be
//! asked about.
//!
//! A broad phase may keep too much and must never drop what matters. The ones
//! here go further: what their users conclude is stated in terms of the raw
//! coordinates, without reference to cells, so an answer can't depend on how
//! the space was cut.
//!
//! * [`Columns`]: the segments above a point, one by one.
//! * [`Cells`]: the segments near a point, and the sum of those far above.
//! * [`BoxIndex`]: the boxes near a box.
//! * [`Raster`]: the segments through each cell of a grid.
//! * [`shared()`]: the boxes of two sets that may meet one of the other set.
//! * [`parallel`]: loops over pieces of work, compiled once. [`sort`]: sorting by signs that may contradict each other.
//!   [`status`]: what a sweep line crosses.
//! * [`two_level`]: the boxes in each cell of a grid in space, whose full cells have grids of their own.

mod bounds;
mod box_index;
mod cells;
mod columns;
pub mod parallel;
mod raster;
mod shared;
pub mod sort;
pub mod status;
mod steps;
pub mod two_level;

pub use bounds::Bounds;
pub use box_index::BoxIndex;
pub use cells::{Cell, Cells, End, Entry, Labels};
pub use columns::Columns;
pub use raster::Raster;
pub use shared::{BoxOf, shared};
