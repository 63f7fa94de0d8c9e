//! Broad phases: the selection, from raw coordinates alone, of the few features that predicates have to test.
//!
//! A broad phase may keep too much and must never drop a relevant feature. The broad phases here guarantee more: their
//! results are specified in terms of the raw coordinates, without reference to cells. So an answer can't depend on the
//! grid.
//!
//! * [`Columns`]: the segments above a point, one by one.
//! * [`Cells`]: the segments near a point, and the sum of the labels far above.
//! * [`BoxIndex`]: the boxes near a box.
//! * [`Raster`]: the segments through each cell of a grid.
//! * [`shared()`]: the boxes of each of two sets that may meet a box of the other set.
//! * [`parallel`]: loops over pieces of work, compiled once. [`sort`]: sorting by signs that may contradict each other.
//!   [`status`]: the sequence of items that a sweep line crosses.
//! * [`tree`]: a tree of boxes, for rays and for nearest pairs.
//! * [`two_level`]: the boxes in each cell of a grid in space, whose crowded cells have nested grids.

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
pub mod tree;
pub mod two_level;

pub use bounds::Bounds;
pub use box_index::BoxIndex;
pub use cells::{Cell, Cells, End, Entry, Labels};
pub use columns::Columns;
pub use raster::Raster;
pub use shared::{BoxOf, shared};
