//! Code that the tests share.

pub mod by_definition;
#[path = "../../../../delaunay/tests/it/common/liar.rs"]
pub mod liar;
