//! Suites given by path are found from any folder, and `solve` writes its files.

use std::path::Path;

use tempfile::tempdir;

use crate::common::{SUITE, Told, at, column, expect, read, told, tool, unsealed, write};

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

    // Make a run that was interrupted before the last row.
    let state = unsealed(&out, "state.json").replace("\"complete\"", "\"interrupted\"");
    std::fs::write(home.path().join("run/state.json"), state).unwrap();
    let resumed = within(elsewhere.path(), &["run", "--resume", &out]);
    assert_eq!(resumed.code, 100, "{}", resumed.stderr);
}

#[test]
fn an_answer_is_written_for_other_programs() {
    let folder = tempdir().unwrap();
    for (suite, scene, files) in [
        ("contacts", "contacts/tetrahedra$", &[("contacts.json", "\"on_a\""), ("complexes.obj", "o b\n")][..]),
        ("cubes", "cubes/twins$", &[("union.json", "\"volume\""), ("measures.json", "\"area\":")]),
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

#[test]
fn a_task_is_solved_on_files_without_a_suite() {
    let folder = tempdir().unwrap();
    let file = |name: &str, text: &str| {
        std::fs::write(folder.path().join(name), text).unwrap();
        at(&folder, name)
    };
    let roads = r#"{"type":"MultiLineString","coordinates":[[[0,0],[1,1]],[[0,0.5],[1,0]]]}"#;
    let roads = file("roads.geojson", roads);
    let tetrahedron =
        |apex: &str| format!("OFF\n4 4 0\n{apex}\n2 0 0\n0 2 0\n0 0 2\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
    let [a, b] = [("a.off", "0 0 0"), ("b.off", "1 1 1")].map(|(name, apex)| file(name, &tetrahedron(apex)));
    let turns = file("turns.csv", "0,0\n1,0\n0,1\n0.1000000000000000001,1\n");
    let out = at(&folder, "out");
    let solve = |code, words: &[&str]| expect(code, &[&["solve"], words, &["--out", &out]].concat());

    solve(0, &["crossings", &roads, "-b", "sos"]);
    assert!(read(&out, "crossings.json").contains(r#""crossed_at":[["c0"]]"#), "{}", read(&out, "crossings.json"));
    assert!(read(&out, "vertices.json").contains(r#""exact":["1/3","1/3"]"#), "{}", read(&out, "vertices.json"));
    solve(0, &["contacts3d", &a, &b]);
    assert!(read(&out, "contacts.json").contains("\"on_a\""));
    solve(0, &["orient2d", &turns, "--round", "--set", "queries=all"]);
    assert_eq!(read(&out, "signs.csv").lines().count(), 5);
    solve(0, &["interval", &turns, "--round", "--set", "cells=[[0, 1]]", "--set", "axis=x"]);

    for (words, needle) in [
        (&["orient2d", &turns][..], "add --round"),
        (&["orient2d", &turns, &roads], "takes one file"),
        (&["orient2d", &turns, "-f", "x"], "leave it out"),
        (&["orient2d", &turns, "--round", "--set", "queries"], "KEY=VALUE"),
        (&["orient2d", &turns, "--round", "--set", "question=all"], "question"),
        (&["orient2d", &turns, "--round", "--set", "queries=1\n[[scene]]"], "line break"),
        (&["contacts3d", &a], "`b`"),
        (&["crossings", &a], "a.off"),
        (&["orient2d", "none.csv"], "none.csv: the data file can't be read: there is no such file; name an existing"),
        (&["orient2d", "tilings", "--set", "queries=all", "-f", "bricks$"], "is for a task on files"),
    ] {
        let told = within(folder.path(), &[&["solve"], words, &["--out", &out]].concat());
        assert!(
            [2, 104].contains(&told.code) && told.stderr.contains(needle),
            "{words:?}: {} {}",
            told.code,
            told.stderr
        );
        assert_eq!(told.stderr.lines().count(), 1, "{}", told.stderr);
    }
}

/// Errors of the operating system name the file and a cure.
#[test]
fn files_that_are_none_are_named_with_a_cure() {
    let folder = tempdir().unwrap();
    let file = write(&folder, "file", "");
    let (missing, out) = (at(&folder, "missing"), at(&folder, "out"));
    let cases: [(&[&str], &str, &str); 7] = [
        (&["run", "--plan", &missing, "--shard", "1/2", "--out", &out], &missing, "name an existing path"),
        (&["run", "lecture", "--out", &file], &file, "name another place"),
        (&["hunt", "orient2d", "-b", "naive", "--out", &file], &file, "name another place"),
        (&["report", &file, "--out", &out], &file, "name another place"),
        (&["data", "export", &missing, "--out", &out], &missing, "name an existing path"),
        (&["setup", "selftest", "--out", &file, "--only", "fault:sos-swapped-term"], &file, "name another place"),
        (&["gate", &missing], &missing, "name another folder"),
    ];
    for (words, path, cure) in cases {
        let told = expect(2, words).stderr;
        assert!(told.contains(path) && told.contains(cure), "{words:?}: {told}");
    }
}
