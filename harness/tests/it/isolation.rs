//! A backend that loops, crashes or takes all memory costs one row, and the run continues.

use crate::common::{at, column, expect, read, run, tool, write};
use tempfile::tempdir;

const SUITE: &str = r#"title = "Mine"

[[scene]]
name = "turn"
task = "orient2d"
points = [[0, 0], [1, 0], [0, 1]]

[[scene]]
name = "order"
task = "compare"
points = [[0, 0], [1, 0]]
"#;

#[test]
fn what_ends_the_process_costs_one_row() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let none = write(&folder, "none.toml", "");
    for (fault, class, check, said) in [
        ("loops", "timeout", "time limit", "took longer than 2.5s"),
        ("panics", "panic", "panic", "planted: a panic"),
        ("overflows-stack", "panic", "crashed", "has overflowed its stack"),
        ("aborts", "panic", "crashed", "abort (signal 6): without a word"),
        ("exits", "panic", "crashed", "ended with code 0: without a word"),
        ("hoards", "panic", "out of memory", "memory allocation of 4611686018427387903 bytes failed"),
    ] {
        let out = at(&folder, fault);
        let backends = format!("fault:{fault},exact");
        // The limit is long enough for a process that does not loop, even on a busy machine.
        let limit: &[&str] = if fault == "loops" { &["--timeout", "2.5"] } else { &[] };
        let args = ["run", &suite, "-b", &backends, "--isolate", "--expected", &none, "--out", &out];
        let told = run(&[&args[..], limit].concat());
        let code = if fault == "loops" { 103 } else { 100 };
        assert_eq!(told.code, code, "{fault}: {}{}", told.stdout, told.stderr);
        let summary = read(&out, "summary.csv");
        assert_eq!(column(&summary, "scene"), ["turn", "turn", "order", "order"], "{fault}: {summary}");
        assert_eq!(column(&summary, class), ["1", "0", "0", "0"], "{fault}: {summary}");
        assert_eq!(column(&summary, "agree"), ["0", "1", "1", "1"], "{fault}: the rest is judged: {summary}");
        assert!(told.stdout.contains(": 3 answers judged"), "{fault}: what was not answered: {}", told.stdout);
        let findings = read(&out, "findings.csv");
        assert_eq!(column(&findings, "check"), [check], "{findings}");
        assert!(findings.contains(said), "{fault}: {findings}");
    }
    // The plan has the selection of a run.
    let refused = expect(2, &["run", "--resume", &at(&folder, "loops"), "-f", "turn"]);
    assert!(refused.stderr.contains("'--resume <DIR>' cannot be used with"), "{}", refused.stderr);
    // A resumed run skips a scene that timed out.
    let resumed = run(&["run", "--resume", &at(&folder, "loops")]);
    assert!(resumed.stdout.ends_with("1 timeout\n"), "{}{}", resumed.stdout, resumed.stderr);
    // Its outcome stays a timeout.
    assert_eq!(resumed.code, 103, "{}", resumed.stdout);
    assert!(resumed.stdout.contains("; incomplete: out of time\n"), "{}", resumed.stdout);
}

#[test]
fn a_worker_that_cannot_work_is_no_row_of_a_backend() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let out = at(&folder, "run");
    let args = ["run", &suite, "-b", "fault:loops,exact", "--isolate", "--timeout", "1", "--out", &out];
    let first = tool(&args).stderr(std::process::Stdio::piped()).spawn().unwrap();
    let worker = folder.path().join(format!("run/worker-{}", first.id()));
    while !worker.join("run/state.json").exists() {
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    // While one worker loops, change the suite for the next worker.
    write(&folder, "mine.toml", "title = ");
    let told = crate::common::told(first.wait_with_output().unwrap());
    assert_eq!(told.code, 104, "{}", told.stderr);
    assert!(told.stderr.contains("mine.toml:1: "), "{}", told.stderr);
    let summary = read(&out, "summary.csv");
    assert_eq!(column(&summary, "backend"), ["fault:loops"], "{summary}");
    assert!(!worker.exists(), "it leaves no files behind");
}

#[test]
fn isolated_rows_are_the_rows() {
    let folder = tempdir().unwrap();
    let (here, apart) = (at(&folder, "here"), at(&folder, "apart"));
    let scenes =
        ["run", "classics", "tilings", "-f", "kettner-(a1|pixels-c)$|tilings/bricks$", "-b", "exact,naive", "--out"];
    run(&[&scenes[..], &[&here]].concat());
    run(&[&scenes[..], &[&apart, "--isolate"]].concat());
    crate::common::assert_same_tables(&here, &apart, "in a process of its own");
    let maps = |run: &str| {
        let mut names: Vec<_> =
            std::fs::read_dir(format!("{run}/maps")).unwrap().map(|e| e.unwrap().file_name()).collect();
        names.sort();
        names
    };
    assert_eq!(maps(&here), maps(&apart));
}

#[test]
fn two_writers_of_one_folder_are_refused() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let out = at(&folder, "run");
    let args = ["run", &suite, "-b", "fault:loops", "--isolate", "--timeout", "60", "--out", &out];
    let mut first = tool(&args).stdout(std::process::Stdio::null()).spawn().unwrap();
    while !folder.path().join("run/state.json").exists() && first.try_wait().unwrap().is_none() {
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    let refused = expect(2, &["run", "--resume", &out]);
    assert!(refused.stderr.contains("another process is writing this run"), "{}", refused.stderr);
    std::process::Command::new("kill").args(["-KILL", &first.id().to_string()]).status().unwrap();
    first.wait().unwrap();
    // The worker ends soon after the process that it works for.
    #[cfg(target_os = "linux")]
    while !crate::common::processes_with(&suite).is_empty() {
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    // The lock ended with the process.
    let gate = run(&["gate", &out]);
    assert_eq!(gate.code, 103, "{}{}", gate.stdout, gate.stderr);
}

#[test]
fn time_limits_are_bounded() {
    let folder = tempdir().unwrap();
    let suite = write(&folder, "mine.toml", SUITE);
    let run = |limit: &str| {
        crate::common::run(&["run", &suite, "-b", "exact", "--timeout", limit, "--out", &at(&folder, "run")])
    };
    for limit in ["0", "nan", "inf", "1e19"] {
        let refused = run(limit);
        assert!(refused.code == 2 && refused.stderr.contains("is not a time limit"), "{limit}: {}", refused.stderr);
    }
    assert_eq!(run("1e9").code, 0);
}

#[test]
fn threads_are_bounded() {
    for threads in ["0", "99999999"] {
        let refused = expect(2, &["run", "--threads", threads]);
        assert!(refused.stderr.contains("threads; choose from 1 to 4096"), "{}", refused.stderr);
    }
}
