//! A clock that goes backwards changes no output.

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use super::driver::{Bench, Shape, children, differing, files, left, signal, with_out, words_of};

/// The tool at another time, with `faketime`.
fn at(time: &str, words: &[String]) -> Command {
    let tool = words_of(words);
    let mut command = Command::new("faketime");
    command.args(["-f", time]).arg(tool.get_program()).args(tool.get_args());
    command.env_remove("PREDICAMENT_CACHE").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
    command
}

#[test]
#[cfg(target_os = "linux")]
fn a_run_that_is_resumed_years_before_it_began_is_the_same() {
    if !Command::new("faketime").args(["-f", "-1d", "true"]).output().is_ok_and(|output| output.status.success()) {
        println!("NOT TRIED: there is no `faketime` here (Debian has it in a package of that name)");
        return;
    }
    let bench = Bench::new(&[Shape::Plain]);
    let out = bench.place("late");
    let mut late = at("@2038-01-19 03:14:00", &with_out(Shape::Plain.words(), &out)).spawn().unwrap();
    let rows = || std::fs::read_to_string(out.join("summary.csv")).map_or(0, |text| text.lines().count());
    while rows() < 5 && late.try_wait().unwrap().is_none() {
        std::thread::sleep(Duration::from_micros(200));
    }
    // Kill the tool; `faketime` waits for it to end.
    for tool in children(late.id()) {
        signal("KILL", i64::from(tool));
    }
    late.wait().unwrap();
    let was = left(&out);
    let resume = ["run", "--quiet", "--resume", &out.display().to_string()].map(str::to_owned);
    let early = at("@1999-12-31 23:59:58", &resume).output().unwrap();
    let code = early.status.code();
    assert!(code == Some(0) || code == Some(100), "{code:?}: {}", String::from_utf8_lossy(&early.stderr));
    let differ = differing(&files(&out), bench.whole(Shape::Plain));
    assert!(differ.is_empty(), "left: {was}: these files differ: {differ:?}");
}

/// The code reads only the monotonic clock. The exceptions are the start time of a run, on which no result depends, and
/// the planted backend whose answers depend on the clock.
#[test]
fn no_code_reads_the_time_of_day() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut left = vec![root.join("harness/src")];
    // Crates are in groups, each in a folder.
    let folders = |of: &Path| {
        std::fs::read_dir(of)
            .unwrap()
            .map(|entry| entry.unwrap().path())
            .filter(|path| path.is_dir())
            .collect::<Vec<_>>()
    };
    for group in folders(&root.join("crates")) {
        left.extend(folders(&group).iter().chain([&group]).map(|one| one.join("src")).filter(|source| source.is_dir()));
    }
    let mut read = 0;
    while let Some(here) = left.pop() {
        for path in std::fs::read_dir(here).into_iter().flatten().map(|entry| entry.unwrap().path()) {
            if path.is_dir() {
                left.push(path);
            } else if path.extension() == Some("rs".as_ref()) {
                let text = std::fs::read_to_string(&path).unwrap();
                let says_when =
                    ["records/src/env.rs", "oracle/src/faults/unsteady.rs"].iter().any(|file| path.ends_with(file));
                let reads = text.contains(concat!("System", "Time"));
                assert!(!reads || says_when, "{} reads the time of day", path.display());
                read += 1;
            }
        }
    }
    assert!(read > 100, "{read} files");
}
