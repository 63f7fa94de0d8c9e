//! Runs the tool as a user would.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// The tool with these arguments and without fetched data.
pub fn tool(args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_predicament"));
    command.args(args).stdin(Stdio::null()).env("RUST_BACKTRACE", "0").env_remove("PREDICAMENT_CACHE");
    command
}

/// The output and the exit code of a call.
pub struct Told {
    pub code: i32,
    pub stdout: String,
    pub stderr: String,
}

/// Runs the tool until it ends.
pub fn run(args: &[&str]) -> Told {
    told(tool(args).output().expect("the tool starts"))
}

pub fn told(output: Output) -> Told {
    Told {
        code: output.status.code().expect("the tool ends by itself"),
        stdout: String::from_utf8(output.stdout).expect("UTF-8"),
        stderr: String::from_utf8(output.stderr).expect("UTF-8"),
    }
}

/// Runs the tool and asserts its exit code.
pub fn expect(code: i32, args: &[&str]) -> Told {
    let told = run(args);
    assert_eq!(told.code, code, "{args:?}\nstdout: {}\nstderr: {}", told.stdout, told.stderr);
    told
}

/// The processes with these words on their command line; a zero separates words.
#[cfg(target_os = "linux")]
pub fn processes_with(words: &str) -> Vec<u32> {
    let ids =
        std::fs::read_dir("/proc").unwrap().flatten().filter_map(|entry| entry.file_name().to_str()?.parse().ok());
    let has_words =
        |id: &u32| std::fs::read_to_string(format!("/proc/{id}/cmdline")).is_ok_and(|line| line.contains(words));
    ids.filter(has_words).collect()
}

/// A path inside a temporary folder, as an argument.
pub fn at(folder: &tempfile::TempDir, name: &str) -> String {
    folder.path().join(name).display().to_string()
}

/// The tables of a folder by name, except those with times. They do not depend on the number of threads.
pub fn tables(folder: &str) -> Vec<(String, String)> {
    let names = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<String> =
        names.filter(|name| name.ends_with(".csv") && name != "throughput.csv" && name != "costs.csv").collect();
    names.sort();
    names.into_iter().map(|name| (name.clone(), read(folder, &name))).collect()
}

/// Asserts that two folders have the same tables, except those with times.
pub fn assert_same_tables(one: &str, other: &str, why: &str) {
    let (one, other) = (tables(one), tables(other));
    let names = |tables: &[(String, String)]| tables.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>();
    assert_eq!(names(&one), names(&other), "{why}");
    for ((name, one), (_, other)) in one.iter().zip(&other) {
        assert!(one == other, "{name}: {why}");
    }
}

pub fn read(folder: &str, file: &str) -> String {
    std::fs::read_to_string(Path::new(folder).join(file)).unwrap_or_else(|error| panic!("{folder}/{file}: {error}"))
}

/// Reads a JSON file of a run folder without its seal, so that a test may change it.
pub fn unsealed(folder: &str, file: &str) -> String {
    read(folder, file).lines().filter(|line| !line.starts_with("  \"seal\"")).map(|line| format!("{line}\n")).collect()
}

/// Rewrites a table of a run folder and its digest in the state, as if the run had written it.
pub fn rewrite(folder: &str, file: &str, text: &str) {
    std::fs::write(Path::new(folder).join(file), text).unwrap();
    let mut state: serde_json::Value = serde_json::from_str(&unsealed(folder, "state.json")).unwrap();
    state["committed"][file] = text.len().into();
    state.as_object_mut().unwrap().remove("digests");
    std::fs::write(Path::new(folder).join("state.json"), state.to_string()).unwrap();
}

/// A column of a CSV file.
pub fn column(csv: &str, name: &str) -> Vec<String> {
    let mut lines = csv.lines();
    let place = lines.next().and_then(|header| header.split(',').position(|column| column == name));
    let place = place.unwrap_or_else(|| panic!("no column {name}"));
    lines.map(|line| line.split(',').nth(place).unwrap_or_default().to_owned()).collect()
}

/// Writes a file and returns its path.
pub fn write(folder: &tempfile::TempDir, name: &str, text: &str) -> String {
    let path: PathBuf = folder.path().join(name);
    std::fs::write(&path, text).expect("the folder is writable");
    path.display().to_string()
}

/// A suite in which naive floating point is wrong once and exact never.
pub const SUITE: &str = r#"title = "Mine"

[[scene]]
name = "wrong-once"
task = "orient2d"
points = [["0x1.0000000000001p-1", "0x1p-1"], ["12", "12"], ["24", "24"]]

[[scene]]
name = "plain"
task = "orient2d"
points = [["0", "0"], ["1", "0"], ["0", "1"]]
"#;
