//! `docs/LECTURE.md`: its claims about each scene, and its pictures.

use std::path::Path;

use tempfile::tempdir;

use crate::common::{at, column, expect, read};

/// The failures that the page claims: scene, backend, class, and the checks of that class's findings.
const FAILURES: &[(&str, &str, &str, &[&str])] = &[
    ("ear-cut-across", "naive", "topology", &["overlap", "positive"]),
    ("loop-that-does-not-close", "naive", "topology", &["the horizon of a vertex is a single loop"]),
    ("concave-face", "naive", "topology", &["piece orientation", "self-intersection"]),
    ("concave-face", "shewchuk", "topology", &["piece orientation", "self-intersection"]),
    ("edges-not-quite-collinear", "naive", "sign_flip", &[]),
    ("split-points-nearly-collocated", "naive", "missed_zero", &["order"]),
    ("orientation-inversion", "naive", "sign_flip", &[]),
    ("orientation-inversion", "shewchuk", "sign_flip", &[]),
    ("cascade", "shewchuk", "rounded", &["cap not in its plane", "wrong side"]),
    ("cascade", "naive", "topology", &["self-intersection", "cap orientation"]),
    ("side-of-an-edge", "naive", "inconsistent", &[]),
    ("tolerance-is-not-transitive", "epsilon:1e-10", "inconsistent", &[]),
];

#[test]
fn each_failure_of_the_lecture_is_shown() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "run");
    expect(0, &["run", "lecture", "--out", &out]);
    let findings = read(&out, "findings.csv");
    let columns = ["scene", "backend", "class", "check"].map(|name| column(&findings, name));
    for (scene, backend, class, checks) in FAILURES {
        let found: Vec<&str> = (0..columns[0].len())
            .filter(|&row| [scene, backend, class] == [0, 1, 2].map(|i| &columns[i][row]))
            .map(|row| columns[3][row].as_str())
            .collect();
        assert!(!found.is_empty(), "{scene} on {backend}: no {class}");
        for check in *checks {
            assert!(found.contains(check), "{scene} on {backend}: {check} is not in {found:?}");
        }
    }
    let right = |backend: &String| ["exact", "sos"].contains(&backend.as_str());
    assert!(!columns[1].iter().any(right), "exact and sos have no finding");
    let scenes: std::collections::BTreeSet<&str> = FAILURES.iter().map(|failure| failure.0).collect();
    let page = std::fs::read_to_string(docs("LECTURE.md")).unwrap();
    for scene in column(&read(&out, "summary.csv"), "scene") {
        assert!(scenes.contains(scene.as_str()) && page.contains(&format!("`{scene}`")), "{scene} is not on the page");
    }
}

#[test]
fn the_pictures_of_the_lecture_are_the_tool_s() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "turn");
    expect(0, &["solve", "lecture", "-f", "orientation-inversion", "--out", &out]);
    let same = |made: &str, shown: &str| {
        let (made, shown) = (std::fs::read(made).unwrap(), std::fs::read(docs(shown)).unwrap());
        assert!(made == shown, "the picture of the page is another one than the tool makes");
    };
    same(&at(&folder, "turn/triangles.svg"), "figures/lecture-orientation-inversion.svg");
    let map = at(&folder, "map.png");
    expect(0, &["draw", "map", "kettner-pixels-a", "--out", &map]);
    same(&map, "figures/lecture-side-of-an-edge.png");
}

fn docs(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs").join(name)
}
