//! Bad input gives one line with a place and a cure, the right exit code, and no half-written output.

use crate::common::{SUITE, at, expect, run, tool, write};
use tempfile::tempdir;

/// Asserts that a call fails with this code and one line on stderr that has these words, and prints nothing else.
fn fails(code: i32, args: &[&str], words: &[&str]) {
    let told = expect(code, args);
    let lines: Vec<&str> = told.stderr.lines().filter(|line| !line.contains("is not run:")).collect();
    assert_eq!(lines.len(), 1, "{args:?}: {}", told.stderr);
    for word in words {
        assert!(lines[0].contains(word), "{args:?}: `{word}` not in {}", lines[0]);
    }
    assert!(told.stdout.is_empty(), "{args:?}: {}", told.stdout);
}

#[test]
fn suites_are_refused_with_file_line_and_cure() {
    for (name, from, to, line, words) in [
        ("nan", "\"0x1p-1\"", "\"nan\"", ":6:", ["nan", "finite"]),
        ("inf", "\"0x1p-1\"", "\"inf\"", ":6:", ["inf", "finite"]),
        ("ragged", "[\"12\", \"12\"]", "[\"12\"]", ":6:", ["coordinate", "point"]),
        ("key", "name = \"plain\"", "name = \"plain\"\ncolour = 1", ":10:", ["colour", ";"]),
        ("inexact", "\"0x1p-1\"", "\"0.1000000000000000001\"", ":6:", ["0.1000000000000000001", "corpus fmt"]),
        ("duplicate", "name = \"plain\"", "name = \"wrong-once\"", ":", ["wrong-once", ";"]),
        ("task", "task = \"orient2d\"", "task = \"orient5d\"", ":5:", ["orient5d", ";"]),
    ] {
        let folder = tempdir().unwrap();
        let text = SUITE.replacen(from, to, 1);
        assert_ne!(text, SUITE, "{name}");
        let suite = write(&folder, &format!("{name}.toml"), &text);
        let out = at(&folder, "run");
        let place = format!("{name}.toml{line}");
        fails(104, &["run", &suite, "--out", &out], &[&place, words[0], words[1]]);
        assert!(!folder.path().join("run").exists(), "{name}: nothing half-written");
    }
}

#[test]
fn a_suite_without_scenes_is_named() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "empty.toml", "title = \"Nothing\"\n");
    let told = format!("no scene of {suite} is selected; `predicament corpus list --scenes` lists");
    for args in [
        &["corpus", "verify", &suite][..],
        &["corpus", "gen", &suite],
        &["run", &suite, "--out", &at(&folder, "run")],
        &["solve", &suite, "-f", ".", "--out", &at(&folder, "solved")],
    ] {
        fails(4, args, &[&told]);
    }
}

#[test]
fn a_scene_twice_is_refused() {
    let folder = tempdir().unwrap();
    let twice = SUITE.replace(
        "[[\"0\", \"0\"], [\"1\", \"0\"], [\"0\", \"1\"]]",
        "[[\"0x1.0000000000001p-1\", \"0x1p-1\"], [\"12\", \"12\"], [\"24\", \"24\"]]",
    );
    let suite = write(&folder, "twice.toml", &twice);
    fails(104, &["corpus", "verify", &suite], &["twice.toml:", "wrong-once", "plain"]);
}

#[test]
fn missing_data_is_an_error_and_never_a_skip() {
    let folder = tempdir().unwrap();
    let (cache, out) = (at(&folder, "cache"), at(&folder, "run"));
    fails(104, &["run", "maps", "--cache", &cache, "--out", &out], &["predicament corpus fetch"]);
    assert!(!folder.path().join("run").exists());
    // Not naming the suite is a choice, and the choice is in the plan.
    expect(0, &["run", "tilings", "-b", "exact", "--cache", &cache, "--out", &out]);
    let plan: serde_json::Value = serde_json::from_str(&crate::common::read(&out, "plan.json")).unwrap();
    let left: Vec<&str> =
        plan["not_selected"].as_array().unwrap().iter().filter_map(|left| left["suite"].as_str()).collect();
    assert!(left.contains(&"maps") && !left.contains(&"tilings"), "{left:?}");
}

#[test]
fn a_truncated_map_is_refused_with_its_place() {
    let folder = tempdir().unwrap();
    write(&folder, "map.json", "{\"type\": \"Topology\",\n \"arcs\": [[[0, 0], [1,");
    let suite = "title = \"Map\"\n[[scene]]\nname = \"m\"\ntask = \"polygon-locate\"\nmap = { topojson = \"map.json\", object = \"o\" }\n";
    let suite = write(&folder, "map.toml", suite);
    fails(104, &["corpus", "verify", &suite], &["map.json:2", ";"]);
}

#[test]
fn usage_is_answered_with_what_there_is() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "run");
    fails(2, &["run", "-b", "exat", "--out", &out], &["exat", "exact, sos"]);
    fails(2, &["run", "-b", "epsilon:-1", "--out", &out], &["epsilon:-1"]);
    fails(2, &["run", "no-such-suite", "--out", &out], &["no-such-suite"]);
    fails(2, &["run", "-f", "(", "--out", &out], &["--filter"]);
    fails(4, &["run", "-f", "matches nothing", "--out", &out], &["no scene is selected", "corpus list"]);
    fails(2, &["run", "--threads", "0", "--out", &out], &["--threads"]);
    fails(2, &["gate", &at(&folder, "nowhere")], &["nowhere"]);
    fails(2, &["bench", "--samples", "0"], &["--samples"]);
    for precision in ["nan", "-1", "-inf", "inf", "1e9", "5", "x"] {
        let option = format!("--precision={precision}");
        let told = run(&["bench", "classics", "-b", "exact", "--samples", "2", &option, "--out", &out]);
        let said = format!("`{precision}` is not a precision; write a fraction such as 0.05");
        assert!(told.code == 2 && told.stderr.contains(&said), "{precision}: {} {}", told.code, told.stderr);
    }
    fails(2, &["corpus", "fetch", "no-such-key"], &["no-such-key", "world-110m"]);
    fails(
        104,
        &["gate", &out, "--expected", &write(&folder, "e.toml", "[[expect]]\nscene = \"*\"\n")],
        &["e.toml:1", "backend"],
    );
    assert!(!folder.path().join("run").exists(), "nothing half-written");
    assert_eq!(tool(&["run", "--no-such-flag"]).output().unwrap().status.code(), Some(2));
}

/// An empty argument, the value of an unset variable of a script, must not select everything.
#[test]
fn nothing_is_no_argument() {
    let folder = tempdir().unwrap();
    let (suite, out) = (write(&folder, "mine.toml", SUITE), at(&folder, "run"));
    let ran = run(&["run", &suite, "-b", "naive", "--out", &out]);
    assert_eq!(ran.code, 100, "{}", ran.stderr);
    let cure = "; write a value, or leave it out";
    for args in [
        &["replay", "", "--run", &out][..],
        &["run", "", "--out", "x"],
        &["run", &suite, "-f", "", "--out", "x"],
        &["run", &suite, "-b", "", "--out", "x"],
        &["run", &suite, "--out", ""],
        &["run", &suite, "--filter=", "--out", "x"],
        &["bench", ""],
        &["gate", ""],
        &["gate", &out, "--expected", ""],
        &["report", "", "--out", "x"],
        &["draw", "map", "", "--out", "x"],
        &["solve", &suite, "-f", "", "-b", "exact", "--out", "x"],
        &["ask", "orient2d", ""],
        &["corpus", "new", ""],
        &["corpus", "new", "x.toml", "--points", ""],
        &["corpus", "fmt", ""],
        &["corpus", "fetch", ""],
        &["engines", "check", ""],
        &["setup", "selftest", "--only", ""],
        &["study", "laws", "-b", ""],
        &[""],
    ] {
        fails(2, args, &[cure]);
    }
    fails(2, &["replay", "", "--run", &out], &["an empty argument behind `replay`; write"]);
    fails(2, &["run", "--filter="], &["`--filter=` without a value behind `run`; write"]);
}

#[test]
fn a_run_is_never_written_over_another() {
    let folder = tempdir().unwrap();
    write(&folder, "keep.txt", "mine");
    let out = folder.path().display().to_string();
    fails(2, &["run", "tilings", "-b", "exact", "--out", &out], &["not empty"]);
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn fmt_cures_what_run_refuses() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", &SUITE.replacen("\"0x1p-1\"", "\"0.1000000000000000001\"", 1));
    expect(104, &["corpus", "verify", &suite]);
    expect(104, &["corpus", "fmt", "--check", &suite]);
    expect(0, &["corpus", "fmt", "--in-place", &suite]);
    expect(0, &["corpus", "fmt", "--check", &suite]);
    expect(0, &["corpus", "verify", &suite]);
    let text = std::fs::read_to_string(&suite).unwrap();
    assert!(text.contains("0x1.999999999999ap-4") && text.contains("0.1000000000000000001"), "{text}");
}
