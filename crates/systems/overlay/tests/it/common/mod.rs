//! Shared code of the tests.
#[path = "../../../../delaunay/tests/it/common/liar.rs"]
#[allow(dead_code, reason = "hulls have more lies")]
pub mod liar;
#[path = "../../../../polygon-locate/tests/it/common/winding.rs"]
#[allow(dead_code, reason = "maps have winding numbers")]
pub mod winding;
