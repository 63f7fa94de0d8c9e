//! The backend against every embedded scene that only compares coordinates, and against this crate's own task.

use leftmost::{ByDifference, Leftmost};

#[test]
fn by_difference_holds() {
    predicament::conformance(ByDifference)
        .task(Leftmost)
        .suites(concat!(env!("CARGO_MANIFEST_DIR"), "/corpora"))
        .filter("compare|^intervals/|^leftmost-suite/")
        .expected(concat!(env!("CARGO_MANIFEST_DIR"), "/expected.toml"))
        .folder(concat!(env!("CARGO_TARGET_TMPDIR"), "/by-difference"))
        .assert();
}
