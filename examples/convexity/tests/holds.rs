//! Runs the tool on the crate's own suite: all findings are expected, and the planted fault is detected.

use std::path::Path;
use std::process::Command;

fn tool(arguments: &[&str]) {
    let ended = Command::new(env!("CARGO_BIN_EXE_convexity")).args(arguments).status().expect("the tool starts");
    assert!(ended.success(), "{arguments:?}: {ended}");
}

#[test]
fn the_suite_holds() {
    let run = Path::new(env!("CARGO_TARGET_TMPDIR")).join("corners");
    if run.exists() {
        std::fs::remove_dir_all(&run).expect("an old run");
    }
    let run = run.to_str().expect("a path in Unicode");
    tool(&["run", "corners", "--out", run]);
    tool(&["gate", run]);
    tool(&["selftest", "--only", "answer:convexity-other-way", "-f", "^corners/"]);
}
