//! Long work on a terminal: it says what it does, and Ctrl-C ends it.
#![cfg(target_os = "linux")]

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use tempfile::tempdir;

use crate::common::{at, tool};
use crate::solved::scattered;

/// The text that the tool writes to a terminal.
fn on_terminal(args: &[&str]) -> String {
    let words: Vec<String> = args.iter().map(|word| format!("'{word}'")).collect();
    let line = format!("'{}' {}", env!("CARGO_BIN_EXE_predicament"), words.join(" "));
    let output = Command::new("script").args(["-qec", &line, "/dev/null"]).stdin(Stdio::null()).output();
    String::from_utf8(output.expect("there is `script`").stdout).unwrap()
}

/// Enough points for every command below to take a second; they divide into queries of three.
const MANY: usize = 60_000;

#[test]
fn long_work_is_not_silent_on_a_terminal() {
    let folder = tempdir().unwrap();
    let (points, out) = (scattered(&folder, MANY), at(&folder, "out"));
    let picture = at(&folder, "picture.json");
    let other = tempdir().unwrap();
    let more = scattered(&other, 4 * MANY);
    let solve = ["solve", "delaunay2d", &points, "--out", &out, "--format", "geojson,svg,wkt"];
    let cases: [&[&str]; 4] = [
        &solve,
        &["draw", "scene", "delaunay2d", &points, "-b", "exact", "--out", &picture],
        &["ask", "incircle", "--points", &more, "-b", "exact", "--format", "csv"],
        &["corpus", "gen", "families", "--level", "full", "-f", "uniform-compare$"],
    ];
    for args in cases {
        let told = on_terminal(args);
        // A spinner begins with the time, and its line is cleared.
        let is_shown = told.contains("00:00:0") && told.contains("\u{1b}[2K");
        assert!(is_shown, "{args:?}: {}", told.chars().take(500).collect::<String>());
    }
    let quiet = on_terminal(&[&["--quiet"], &solve[..]].concat());
    assert!(!quiet.contains("00:00:0") && !quiet.contains('\u{1b}'), "{quiet}");
    // Without a terminal there is nothing but the notes.
    let piped = tool(&solve).output().unwrap();
    assert_eq!(String::from_utf8(piped.stderr).unwrap(), "");
}

/// Ctrl-C while files are written, and before: whole files stay, and no part of one.
#[test]
fn an_interrupt_leaves_no_half_written_file() {
    let folder = tempdir().unwrap();
    let points = scattered(&folder, MANY);
    let is_part = |path: &Path| path.to_string_lossy().ends_with(".next");
    let entries = |out: &str| -> Vec<std::path::PathBuf> {
        std::fs::read_dir(out).map_or_else(|_| Vec::new(), |all| all.map(|entry| entry.unwrap().path()).collect())
    };
    for early in [true, false] {
        let out = at(&folder, if early { "early" } else { "late" });
        let mut child = tool(&["solve", "delaunay2d", &points, "--out", &out, "--format", "geojson,svg,wkt,json"])
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let start = Instant::now();
        let is_time = || match early {
            true => start.elapsed() > Duration::from_millis(200),
            false => entries(&out).iter().any(|path| is_part(path)),
        };
        while !is_time() {
            assert!(child.try_wait().unwrap().is_none() && start.elapsed() < Duration::from_secs(60), "too fast");
            std::thread::sleep(Duration::from_millis(5));
        }
        let asked = Instant::now();
        Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
        let ended = child.wait_with_output().unwrap();
        assert_eq!(ended.status.code(), Some(103), "{}", String::from_utf8_lossy(&ended.stderr));
        assert!(asked.elapsed() < Duration::from_secs(10), "at once");
        assert!(String::from_utf8_lossy(&ended.stderr).contains("stopped; "));
        for path in entries(&out) {
            assert!(!is_part(&path), "{}", path.display());
        }
    }
}

/// Ctrl-C ends the other commands that may take long.
#[test]
fn an_interrupt_ends_what_draws_asks_and_generates() {
    let folder = tempdir().unwrap();
    let points = scattered(&folder, 5 * MANY);
    let picture = at(&folder, "picture.json");
    let cases: [&[&str]; 3] = [
        &["draw", "scene", "delaunay2d", &points, "-b", "exact", "--out", &picture],
        &["ask", "orient2d", "--points", &points, "-b", "exact,naive"],
        &["corpus", "gen", "--level", "full"],
    ];
    for args in cases {
        let mut child = tool(args).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        std::thread::sleep(Duration::from_millis(300));
        assert!(child.try_wait().unwrap().is_none(), "{args:?} takes longer");
        Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
        assert_eq!(child.wait().unwrap().code(), Some(103), "{args:?}");
        assert!(!Path::new(&picture).exists());
    }
}
