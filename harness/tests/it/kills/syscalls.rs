//! Kills at each system call with which a run changes its folder, by `strace`. Timed kills rarely hit these.

use std::process::{Command, Stdio};

use super::driver::{Bench, Shape, differing, files, left, with_out, words_of};
use predicament_corpus::Random;

/// The calls that change files.
const CALLS: &str = "write,rename,renameat,renameat2,openat,mkdir,mkdirat,ftruncate,unlink,unlinkat,rmdir";

/// The tool under `strace`, which does `what` to it at the n-th of each of these calls.
fn traced(words: &[String], what: &str, n: usize) -> Command {
    let tool = words_of(words);
    let mut command = Command::new("strace");
    command.args(["-f", "-q", "-o", "/dev/null", "-e", &format!("trace={CALLS}")]);
    command.args(["-e", &format!("inject={CALLS}:{what}:when={n}")]).arg(tool.get_program()).args(tool.get_args());
    command.env_remove("PREDICAMENT_CACHE").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
    command
}

/// The number of calls of the most frequent system call; `strace` counts each system call separately.
fn calls(words: &[String]) -> i64 {
    let log = tempfile::NamedTempFile::new().unwrap();
    let tool = words_of(words);
    let mut command = Command::new("strace");
    command.args(["-f", "-q", "-e", &format!("trace={CALLS}"), "-o"]).arg(log.path());
    command.arg(tool.get_program()).args(tool.get_args()).env_remove("PREDICAMENT_CACHE").stdin(Stdio::null());
    let code = command.output().unwrap().status.code();
    assert!(code == Some(0) || code == Some(100), "{code:?}");
    let text = std::fs::read_to_string(log.path()).unwrap();
    // Count the calls of the first thread, which writes all files.
    let first = text.split_whitespace().next().unwrap_or_default();
    let mut counts = std::collections::BTreeMap::new();
    for call in text.lines().filter_map(|line| line.strip_prefix(first)?.trim().split_once('(')) {
        *counts.entry(call.0.to_owned()).or_insert(0) += 1;
    }
    counts.into_values().max().unwrap_or(0)
}

/// True if `strace` exists and may trace.
pub fn can_trace() -> bool {
    let tried = Command::new("strace").args(["-f", "-q", "-o", "/dev/null", "true"]).output();
    let can = tried.is_ok_and(|output| output.status.success());
    if !can {
        println!("NOT TRIED: there is no `strace` here that may trace");
    }
    can
}

/// A small run on one thread, so that its system calls are always the same.
fn small(out: &std::path::Path) -> Vec<String> {
    let words = [
        "run",
        "classics",
        "ties",
        "-f",
        "kettner-a1$|kettner-pixels-c$|ties/coincident",
        "-b",
        "exact,naive",
        "--threads",
        "1",
        "--quiet",
    ];
    with_out(words.map(str::to_owned).into(), out)
}

#[test]
#[cfg(target_os = "linux")]
fn what_is_killed_at_any_call_to_the_system_is_gone_on_with() {
    if !can_trace() {
        return;
    }
    let (bench, seed) = (tempfile::tempdir().unwrap(), super::random::seed());
    let place = |name: &str| bench.path().join(name);
    let whole = place("whole");
    let all = calls(&small(&whole));
    let whole = files(&whole);
    let mut random = Random::new("kills", "calls", seed);
    let tries = if predicament_effort::whole() { 60 } else { 3 };
    let mut hits = 0;
    for case in 0..tries {
        let n = usize::try_from(random.integer(1, all)).unwrap();
        let what = if case % 3 == 2 { "error=ENOSPC" } else { "signal=KILL" };
        let out = place(&format!("case {case}"));
        let ended = traced(&small(&out), what, n).output().unwrap();
        let about = format!("case {case} of seed {seed}: {what} at call {n} of {all}");
        hits += u32::from(!ended.status.code().is_some_and(|code| code == 0 || code == 100));
        let was = left(&out);
        let words = if out.join("plan.json").exists() {
            ["run", "--quiet", "--resume", &out.display().to_string()].map(str::to_owned).into()
        } else {
            small(&out)
        };
        let told = crate::common::told(words_of(&words).output().unwrap());
        let fine = [0, 100].contains(&told.code) || was == "complete" && told.stderr.contains("nothing to resume");
        assert!(fine, "{about}: left: {was}: code {}: {}", told.code, told.stderr);
        let differ = differing(&files(&out), &whole);
        assert!(differ.is_empty(), "{about}: left: {was}: these files differ: {differ:?}");
        println!("{about}: ended with {}; left: {was}; identical", ended.status);
        std::fs::remove_dir_all(&out).unwrap();
    }
    assert!(hits > 0, "no call was hit");
}

/// Kills merges at system calls: the merged run is complete or does not exist.
pub fn kill_merges(bench: &Bench, seed: u64) {
    if !can_trace() {
        return;
    }
    let mut random = Random::new("kills", "calls of merge", seed);
    let all = calls(&bench.merge(&bench.place("merge counted")));
    for case in 0..if predicament_effort::whole() { 30 } else { 1 } {
        let out = bench.place(&format!("merge {case}"));
        let n = usize::try_from(random.integer(1, all)).unwrap();
        let what = if case % 3 == 2 { "error=ENOSPC" } else { "signal=KILL" };
        let ended = traced(&bench.merge(&out), what, n).output().unwrap();
        let about = format!("case {case} of seed {seed}: a merge, {what} at call {n} of {all}");
        let (was, became) = bench.settle_merge(&out, &about);
        println!("{about}: ended with {}; left: {was}; {became}", ended.status);
        assert_eq!(files(&out), *bench.whole(Shape::Plain));
        std::fs::remove_dir_all(&out).unwrap();
    }
}
