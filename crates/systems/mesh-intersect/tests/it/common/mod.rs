//! Shared code of the tests.

#[path = "../../../../delaunay/tests/it/common/liar.rs"]
pub mod liar;
pub mod overlaid;
pub mod shapes;
pub mod surfaces;
pub mod touching;
pub mod volumes;
