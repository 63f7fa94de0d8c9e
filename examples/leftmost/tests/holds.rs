//! Tests the backend on every embedded scene that only compares coordinates, and on this crate's own task; tests the
//! tool on the crate's own suite.

use std::path::Path;
use std::process::Command;

use leftmost::{ByDifference, Leftmost};

#[test]
fn by_difference_holds() {
    predicament::conformance(ByDifference)
        .task(Leftmost)
        .suites(concat!(env!("CARGO_MANIFEST_DIR"), "/corpora"))
        .filter("compare($|-)|^intervals/|^leftmost-suite/")
        .expected(concat!(env!("CARGO_MANIFEST_DIR"), "/expected.toml"))
        .folder(concat!(env!("CARGO_TARGET_TMPDIR"), "/by-difference"))
        .assert();
}

fn tool(arguments: &[&str]) {
    let ended = Command::new(env!("CARGO_BIN_EXE_leftmost")).args(arguments).status().expect("the tool starts");
    assert!(ended.success(), "{arguments:?}: {ended}");
}

#[test]
fn the_suite_holds() {
    let run = Path::new(env!("CARGO_TARGET_TMPDIR")).join("leftmost-suite");
    if run.exists() {
        std::fs::remove_dir_all(&run).expect("an old run");
    }
    let run = run.to_str().expect("a path in Unicode");
    tool(&["run", "leftmost-suite", "--out", run]);
    tool(&["gate", run]);
    tool(&["selftest", "--only", "answer:leftmost-first-only", "-f", "^leftmost-suite/"]);
}

#[test]
fn the_study_counts_a_column() {
    tool(&["study", "column", "-n", "12"]);
}
