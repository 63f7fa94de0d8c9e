//! Several processes that write one output at once: each succeeds, the output is complete, and no edit is lost.

use std::process::{Child, Stdio};

use tempfile::{TempDir, tempdir};

use crate::common::{SUITE, at, column, expect, read, told, tool, write};

/// The number of writers: more than the processors of CI machines.
fn writers() -> usize {
    if predicament_effort::whole() { 10 } else { 4 }
}

/// Calls the tool several times at once; each call has to end with this code.
fn at_once(code: i32, calls: &[Vec<String>]) {
    let start = |call: &Vec<String>| -> Child {
        let words: Vec<&str> = call.iter().map(String::as_str).collect();
        tool(&words).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
    };
    let children: Vec<Child> = calls.iter().map(start).collect();
    for (child, call) in children.into_iter().zip(calls) {
        let told = told(child.wait_with_output().unwrap());
        assert_eq!(told.code, code, "{call:?}: {}{}", told.stdout, told.stderr);
    }
}

fn words(words: &[&str]) -> Vec<String> {
    words.iter().map(|&word| word.to_owned()).collect()
}

/// The files of a folder, by name. No temporary files and locks remain.
fn files(folder: &str) -> Vec<(String, Vec<u8>)> {
    let mut files: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap())
        .map(|entry| (entry.file_name().into_string().unwrap(), std::fs::read(entry.path()).unwrap_or_default()))
        .collect();
    files.sort();
    assert!(
        files.iter().all(|(name, _)| !name.starts_with('.')),
        "{:?}",
        files.iter().map(|f| &f.0).collect::<Vec<_>>()
    );
    files
}

/// A run with a finding, and its folder.
fn run(folder: &TempDir) -> String {
    let (suite, run) = (write(folder, "mine.toml", SUITE), at(folder, "run"));
    expect(100, &["run", &suite, "-b", "exact,naive", "--out", &run]);
    run
}

#[test]
fn outputs_are_those_of_one_writer() {
    let folder = tempdir().unwrap();
    let run = run(&folder);
    let id = column(&read(&run, "findings.csv"), "finding_id")[0].clone();
    for (code, out, call) in [
        (100, "junit.xml", words(&["gate", &run, "--junit"])),
        (100, "comment.md", words(&["gate", &run, "--summary"])),
        (0, "report", words(&["report", &run, "--out"])),
        (0, "tables", words(&["data", "export", &run, "--out"])),
        (0, "map.png", words(&["draw", "map", "kettner-pixels-a", "-b", "exact", "--out"])),
        (0, "finding.html", words(&["draw", "scene", "--finding", &id, "--run", &run, "--out"])),
    ] {
        let into = |name: &str| {
            let place = folder.path().join(name);
            std::fs::create_dir(&place).unwrap();
            let call: Vec<String> = call.iter().cloned().chain([place.join(out).display().to_string()]).collect();
            (place, call)
        };
        let ((alone, one), (together, each)) = (into("alone"), into("together"));
        at_once(code, &[one]);
        at_once(code, &vec![each; writers()]);
        let in_folder = |place: &std::path::Path| {
            let is_folder = place.join(out).is_dir();
            let names = files(&place.display().to_string());
            if is_folder { files(&place.join(out).display().to_string()) } else { names }
        };
        let (alone_has, together_has) = (in_folder(&alone), in_folder(&together));
        let names = |files: &[(String, Vec<u8>)]| files.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>();
        assert_eq!(names(&alone_has), names(&together_has), "{out}");
        for ((name, one), (_, other)) in alone_has.iter().zip(&together_has) {
            // Only the footer of a Parquet file may have the time of writing.
            assert!(one == other || name.ends_with(".parquet"), "{out}: {name} differs");
        }
        std::fs::remove_dir_all(alone).unwrap();
        std::fs::remove_dir_all(together).unwrap();
    }
}

/// Each writer adds another expectation, and no reported edit is lost.
#[test]
fn no_edit_in_place_is_lost() {
    let folder = tempdir().unwrap();
    let known = write(&folder, "known.toml", "");
    let (mut calls, mut scenes) = (Vec::new(), Vec::new());
    for writer in 0..writers() {
        let name = format!("suite-{writer}");
        let text = SUITE.replace("[\"0\", \"1\"]", &format!("[\"0\", \"{}\"]", writer + 1));
        let suite = write(&folder, &format!("{name}.toml"), &text);
        let run = at(&folder, &format!("run-{writer}"));
        let suite = suite.as_str();
        expect(100, &["run", suite, "-b", "epsilon:1e300", "--out", &run]);
        calls.push(words(&["corpus", "expect", "update", &run, "--expected", &known, "--reason", "ten writers"]));
        scenes.push(format!("\"{name}/"));
    }
    at_once(0, &calls);
    let text = std::fs::read_to_string(&known).unwrap();
    for scene in scenes {
        assert!(text.contains(&scene), "{scene} is lost: {text}");
    }
}
