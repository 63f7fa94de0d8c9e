//! Shared code of the tests.

pub mod agreement;
pub mod maps;
pub mod rings;
pub mod turns;
pub mod winding;

#[path = "../../../../../instrument/laws/tests/it/common.rs"]
#[allow(dead_code, reason = "the laws have more faults")]
pub mod faulty;
pub mod problems;
