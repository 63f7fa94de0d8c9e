//! The exit code when stdout is closed or can't be written.
#![cfg(target_os = "linux")]

use std::fs::File;
use std::process::{Output, Stdio};

use tempfile::tempdir;

use crate::common::{SUITE, at, run, tool, write};

/// A run with a finding, and two files of expectations: the gate fails with the first and passes with the second.
struct Gate {
    _folder: tempfile::TempDir,
    red: Vec<String>,
    green: Vec<String>,
}

impl Gate {
    fn new() -> Gate {
        let folder = tempdir().unwrap();
        let (suite, out) = (write(&folder, "mine.toml", SUITE), at(&folder, "run"));
        let none = write(&folder, "none.toml", "");
        let text =
            "[[expect]]\nscene = \"wrong-once\"\nbackend = \"naive\"\nclass = \"overreach\"\nreason = \"rounding\"\n";
        let all = write(&folder, "all.toml", text);
        run(&["run", &suite, "--expected", &none, "-b", "naive", "--out", &out]);
        let by = |expected: String| ["gate".to_owned(), out.clone(), "--expected".to_owned(), expected].to_vec();
        Gate { red: by(none), green: by(all), _folder: folder }
    }
}

fn gate(args: &[String], stdout: impl Into<Stdio>) -> Output {
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    tool(&args).stdout(stdout).stderr(Stdio::piped()).spawn().unwrap().wait_with_output().unwrap()
}

/// A pipe without a reader.
fn closed() -> std::io::PipeWriter {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    writer
}

fn full() -> File {
    File::options().write(true).open("/dev/full").unwrap()
}

#[test]
fn a_reader_that_goes_away_changes_no_exit_code() {
    let Gate { red, green, _folder } = Gate::new();
    for (args, code) in [(red, 100), (green, 0)] {
        let ended = gate(&args, closed());
        assert_eq!((ended.status.code(), ended.stderr.as_slice()), (Some(code), &b""[..]));
    }
}

#[test]
fn lost_output_is_an_error_and_never_hides_a_finding() {
    let Gate { red, green, _folder } = Gate::new();
    for (args, code) in [(red, 100), (green, 2)] {
        let ended = gate(&args, full());
        assert_eq!(ended.status.code(), Some(code));
        assert!(String::from_utf8_lossy(&ended.stderr).contains("some of the output is lost"));
    }
}

#[test]
fn a_full_stderr_changes_no_exit_code() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let run = |out: &str, suite: &str, backend: &str| {
        let args = ["run", suite, "-b", backend, "--out", &at(&folder, out)];
        tool(&args).stderr(full()).stdout(Stdio::null()).status().unwrap().code()
    };
    assert_eq!(run("green", &suite, "exact"), Some(0));
    assert_eq!(run("red", &suite, "naive"), Some(100));
    assert_eq!(run("none", "no-such-suite", "exact"), Some(2));
}
