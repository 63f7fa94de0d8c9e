//! The backend against every embedded scene that only compares coordinates.

use leftmost::ByDifference;

#[test]
fn by_difference_holds() {
    predicament::conformance(ByDifference)
        .filter("compare|^intervals/")
        .expected(concat!(env!("CARGO_MANIFEST_DIR"), "/expected.toml"))
        .folder(concat!(env!("CARGO_TARGET_TMPDIR"), "/by-difference"))
        .assert();
}
