//! Two meshes through the tool: with the paper's perturbation, from files, and where they touch.

use crate::common::{at, expect, read, write};
use tempfile::tempdir;

const OFF: &str = "OFF\n4 4 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

#[test]
fn a_mesh_that_moves_as_a_whole_has_no_findings() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "run");
    // Scenes drawn by hand and from bug reports, the smallest of each family of meshes, and every placement of two
    // spheres.
    let few = ["-f", "/[^i]|/(into|in-)|-mesh-intersect-placed-(same|nearly|offset|quarter|tiny|tangent|step|half)$"];
    let scenes: &[&str] = if predicament_effort::whole() { &[] } else { &few };
    expect(0, &[&["run", "-q", "intersections", "-b", "sos:per-mesh", "--out", &out], scenes].concat());
    let summary = read(&out, "summary.csv");
    assert!(summary.lines().count() > 30 && summary.lines().skip(1).all(|row| row.ends_with(",ok")), "{summary}");
}

#[test]
fn two_files_are_cut_and_touches_are_named() {
    let folder = tempdir().unwrap();
    let first = write(&folder, "first.off", OFF);
    let out = at(&folder, "out");
    // A mesh with itself: for registered contacts a vertex is on a vertex, for exact both are one solid, and the
    // perturbation decides.
    let told = expect(2, &["solve", "mesh-intersect", &first, &first, "-b", "tolerance", "--out", &out]);
    assert!(told.stderr.contains("of the first mesh is within the tolerance of"), "{}", told.stderr);
    let told = expect(0, &["solve", "mesh-intersect", &first, &first, "--out", &at(&folder, "exactly")]);
    assert!(told.stderr.contains("the mesh difference is empty"), "{}", told.stderr);
    expect(0, &["solve", "mesh-intersect", &first, &first, "-b", "sos:per-mesh", "--out", &out]);
    let faces = |name: &str| {
        let text = read(&out, &format!("{name}.off"));
        let counts = text.lines().nth(1).unwrap().split_ascii_whitespace().nth(1).unwrap().parse::<usize>();
        counts.unwrap()
    };
    // Both operands have the same volume; the part in only one of them is a sheet without volume.
    assert!(faces("union") >= 4 && faces("intersection") >= 4);
    let pieces: serde_json::Value = serde_json::from_str(&read(&out, "pieces.json")).unwrap();
    assert!(pieces["broken"].is_null() && pieces["pieces"].as_array().unwrap().len() >= 8);
}
