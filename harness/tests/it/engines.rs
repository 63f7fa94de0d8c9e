//! The example engines, built and run as their pages say. They need a C++ compiler and Python: `cargo xtask test` runs
//! these tests where it finds them, and says so where it does not.

use crate::common::{at, read, tool};
use tempfile::tempdir;

/// An engine that computes what `naive` computes has the same rows as `naive`, but for its name.
/// (orient3d is expanded in another order there: where nothing is near a tie, that is no difference.)
fn agrees_with_naive(engine: &str) {
    let folder = tempdir().unwrap();
    let engines = concat!(env!("CARGO_MANIFEST_DIR"), "/../engines");
    let call = |args: &[&str]| {
        let output = tool(args).env("PREDICAMENT_ENGINES", engines).output().unwrap();
        let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
        (output.status.code(), text(output.stdout) + &text(output.stderr))
    };
    let built = call(&["engines", "build", engine]);
    assert_eq!(built.0, Some(0), "{}", built.1);
    let out = at(&folder, "run");
    let backends = format!("naive,engine:{engine}");
    let filter = "/(uniform|grid|near|kettner|wide-mixed)-(compare|orient2d|incircle)|/(uniform|grid)-orient3d";
    let ran = call(&["run", "families", "-f", filter, "-b", &backends, "--out", &out]);
    assert_eq!(ran.0, Some(100), "its mistakes are expected of nobody: {}", ran.1);
    let summary = read(&out, "summary.csv");
    // Everything between the backend and the status.
    let rows = |backend: &str| -> Vec<String> {
        let of = summary.lines().filter(|line| line.split(',').nth(4) == Some(backend));
        of.map(|line| line.replace(backend, "").rsplit_once(',').unwrap().0.to_owned()).collect()
    };
    let (ours, theirs) = (rows("naive"), rows(&format!("engine:{engine}")));
    assert!(ours.len() >= 10, "{summary}");
    assert_eq!(ours, theirs);
    let findings = read(&out, "findings.csv");
    assert!(findings.lines().any(|line| line.contains(&format!("engine:{engine}"))), "{findings}");
}

#[test]
#[ignore = "needs a C++ compiler"]
fn the_example_in_cpp_is_built_and_judged() {
    agrees_with_naive("naive-cpp");
}

#[test]
#[ignore = "needs Python"]
fn the_example_in_python_is_judged() {
    agrees_with_naive("naive-python");
}
