//! Suites named by a path, found again from anywhere, and the files that `solve` writes.

use std::path::Path;

use tempfile::tempdir;

use crate::common::{SUITE, Told, at, column, expect, read, told, tool, write};

/// Runs the tool in a folder.
fn within(folder: &Path, args: &[&str]) -> Told {
    told(tool(args).current_dir(folder).output().expect("the tool starts"))
}

#[test]
fn suites_by_path_are_found_from_another_folder() {
    let (home, elsewhere) = (tempdir().unwrap(), tempdir().unwrap());
    write(&home, "mine.toml", SUITE);
    let run = within(home.path(), &["run", "mine.toml", "-b", "naive,exact", "--out", "run"]);
    assert_eq!(run.code, 100, "{}", run.stderr);
    let out = at(&home, "run");
    assert!(read(&out, "plan.json").contains("\"paths\""));

    let id = &column(&read(&out, "findings.csv"), "finding_id")[0];
    let replay = within(elsewhere.path(), &["replay", id, "--run", &out, "-b", "exact"]);
    assert_eq!(replay.code, 0, "{}", replay.stderr);
    assert!(replay.stdout.contains("mine/wrong-once"), "{}", replay.stdout);

    // As if it had been interrupted before the last row.
    let state = read(&out, "state.json").replace("\"complete\"", "\"interrupted\"");
    std::fs::write(home.path().join("run/state.json"), state).unwrap();
    let resumed = within(elsewhere.path(), &["run", "--resume", &out]);
    assert_eq!(resumed.code, 100, "{}", resumed.stderr);
}

#[test]
fn an_answer_is_written_for_other_programs() {
    let folder = tempdir().unwrap();
    for (suite, scene, files) in [
        ("contacts", "contacts/tetrahedra$", &[("contacts.json", "\"on_a\""), ("complexes.obj", "o b\n")][..]),
        ("cubes", "cubes/twins$", &[("union.json", "\"volume\"")]),
        ("tilings", "tilings/bricks$", &[("probes.geojson", "FeatureCollection")]),
    ] {
        let out = at(&folder, suite);
        let told = expect(0, &["solve", suite, "-f", scene, "-b", "exact", "--out", &out]);
        assert_eq!(told.stdout.lines().count(), files.len(), "{}", told.stdout);
        for (file, needle) in files {
            assert!(told.stdout.contains(file) && read(&out, file).contains(needle), "{file}: {}", told.stdout);
        }
    }
    let out = at(&folder, "many");
    assert!(expect(2, &["solve", "cubes", "--out", &out]).stderr.contains("choose one scene with -f"));
    assert!(expect(2, &["solve", "tilings", "-f", "bricks$", "-b", "exat", "--out", &out]).stderr.contains("exat"));
}
