//! The study of scale: each row has a process of its own, which can die, be killed and be stopped.

use crate::common::{at, column, expect, read};
use tempfile::tempdir;

/// The bytes of these backends on one scene.
#[cfg(target_os = "linux")]
fn bytes(backends: &str) -> Vec<f64> {
    let folder = tempdir().unwrap();
    let (out, n) = (at(&folder, "out"), predicament_effort::some_or_all("20000", "200000"));
    let study = ["study", "scale", "-t", "overlay2d", "--threads", "1"];
    expect(0, &[&study[..], &["-b", backends, "--min", n, "--max", n, "--out", &out]].concat());
    column(&read(&out, "scale.csv"), "bytes").into_iter().map(|bytes| bytes.parse().unwrap()).collect()
}

/// A process uses the memory of earlier answers again: in one process the second row would have a quarter less.
#[cfg(target_os = "linux")]
#[test]
fn the_bytes_of_a_row_depend_on_no_other_row() {
    let (one, other) = ("exact", "exact:without=nothing");
    let alone = [one, other].map(|backend| bytes(backend)[0]);
    for (backends, alone) in [(format!("{one},{other}"), alone), (format!("{other},{one}"), [alone[1], alone[0]])] {
        for (together, alone) in bytes(&backends).into_iter().zip(alone) {
            assert!((together / alone - 1.0).abs() < 0.1, "{backends}: {together} beside others, {alone} alone");
        }
    }
}

#[test]
fn a_process_that_dies_costs_its_row() {
    let folder = tempdir().unwrap();
    let out = at(&folder, "out");
    let backends = "fault:hoards,fault:aborts,fault:exits,fault:panics,exact";
    let told = expect(0, &["study", "scale", "-t", "delaunay2d", "--max", "10000", "-b", backends, "--out", &out]);
    let csv = read(&out, "scale.csv");
    let outcomes = ["out of memory", "crashed", "crashed", "panic", "answered"];
    assert_eq!(column(&csv, "outcome"), outcomes, "{csv}");
    for said in [
        "out of memory: memory allocation of 4611686018427387903 bytes failed",
        "crashed: abort (signal 6): without a word",
        "crashed: ended without a row",
        "panic: planted: a panic",
    ] {
        assert!(told.stdout.contains(said), "{said}: {}", told.stdout);
    }
}

#[cfg(target_os = "linux")]
mod signals {
    use std::process::{Child, Command, Stdio};

    use crate::common::{Told, processes_with, told, tool};

    /// A study whose first row never ends, once its process has started; and that process.
    fn looping(seed: &str) -> (Child, u32) {
        let backends = ["-b", "fault:loops", "-b", "exact"];
        let study = [&["study", "scale", "-t", "delaunay2d", "--max", "10000", "--seed", seed][..], &backends].concat();
        let study = tool(&study).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let row = loop {
            match processes_with(&row_of(seed)).first() {
                Some(&row) => break row,
                None => std::thread::sleep(std::time::Duration::from_millis(2)),
            }
        };
        (study, row)
    }

    /// Words that the process of the row has, and the process that started it has not.
    fn row_of(seed: &str) -> String {
        format!("--alone\0-t\0delaunay2d\0--min\010000\0--max\010000\0--memory\08\0--seed\0{seed}\0-b\0fault:loops")
    }

    fn ended(study: Child, signal: &str, process: u32) -> Told {
        Command::new("kill").args([signal, &process.to_string()]).status().unwrap();
        told(study.wait_with_output().unwrap())
    }

    #[test]
    fn a_process_that_is_killed_costs_its_row() {
        let (study, row) = looping("73100001");
        let told = ended(study, "-KILL", row);
        assert_eq!(told.code, 0, "{}", told.stderr);
        for said in ["out of memory: killed by the system (signal 9): without a word |", "| answered |"] {
            assert!(told.stdout.contains(said), "{said}: {}", told.stdout);
        }
    }

    #[test]
    fn an_interrupt_ends_the_process_of_the_row() {
        let (study, _) = looping("73100002");
        let process = study.id();
        let told = ended(study, "-INT", process);
        assert_eq!(told.code, 103, "{}", told.stderr);
        assert!(told.stderr.contains("interrupted; nothing was printed"), "{}", told.stderr);
        assert!(processes_with(&row_of("73100002")).is_empty());
    }
}
