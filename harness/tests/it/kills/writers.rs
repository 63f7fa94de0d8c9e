//! Other writers that are killed, and two writers of the same place.

use std::path::Path;
use std::process::Stdio;
use std::time::Duration;

use tempfile::tempdir;

use super::driver::{files, signal};
use crate::common::{SUITE, at, expect, read, run, told, tool, write};

/// A process locks the folder before it writes anything.
#[test]
fn two_processes_on_one_folder_are_refused_with_a_cure() {
    let folder = tempdir().unwrap();
    let place = |name: &str| at(&folder, name);
    let scene = ["run", "classics", "-f", "kettner-a1$", "-b", "exact", "--quiet"];
    let of = |more: &[&str], out: &str| expect(0, &[&scene[..], more, &["--out", out]].concat());
    let (whole, parts) = (place("whole"), ["1", "2"].map(place));
    of(&[], &whole);
    of(&["--shard", "1/2"], &parts[0]);
    of(&["--shard", "2/2"], &parts[1]);
    let out = place("busy");
    std::fs::create_dir(&out).unwrap();
    std::fs::copy(format!("{whole}/plan.json"), format!("{out}/plan.json")).unwrap();
    let lock = std::fs::File::create(format!("{out}/run.lock")).unwrap();
    lock.try_lock().unwrap();
    let refused = expect(2, &["run", "--resume", &out]);
    assert!(
        refused.stderr.contains("busy: another process is writing this run; wait for its end"),
        "{}",
        refused.stderr
    );
    let refused = expect(2, &[&scene[..], &["--out", &out]].concat());
    assert!(refused.stderr.contains("the folder is not empty; name another"), "{}", refused.stderr);

    // Two merges into the same place.
    let (merged, beside) = (place("both"), place("both.merging"));
    std::fs::create_dir(&beside).unwrap();
    let other = std::fs::File::create(format!("{beside}/run.lock")).unwrap();
    other.try_lock().unwrap();
    let merge = ["shard", "merge", &parts[0], &parts[1], "--out", &merged];
    let refused = expect(2, &merge);
    assert!(refused.stderr.contains("both.merging: another process is writing"), "{}", refused.stderr);
    assert!(Path::new(&beside).exists(), "its folder is not taken from another process");
    drop(other);
    expect(0, &merge);
    assert_eq!(files(Path::new(&merged)), files(Path::new(&whole)));
    assert!(!Path::new(&beside).exists());

    // The lock ends with the process. The folder has only the plan, so the run begins.
    drop(lock);
    expect(0, &["run", "--quiet", "--resume", &out]);
    assert_eq!(files(Path::new(&out)), files(Path::new(&whole)));
}

/// A resumed run has all settings of its plan on which rows depend.
#[test]
fn a_run_that_is_resumed_keeps_its_permutations_and_expectations() {
    let folder = tempdir().unwrap();
    let (whole, out) = (at(&folder, "whole"), at(&folder, "out"));
    let suite = write(&folder, "mine.toml", SUITE);
    let expected = "[[expect]]\nscene = \"wrong-once\"\nbackend = \"naive\"\nclass = \"overreach\"\nreason = \"r\"\n";
    let expected = write(&folder, "mine-expected.toml", expected);
    let words =
        ["run", &suite, "-b", "naive", "--permutations", "0", "--expected", &expected, "--quiet", "--out", &whole];
    expect(0, &words);
    // A folder as it is before any work.
    std::fs::create_dir(&out).unwrap();
    std::fs::copy(format!("{whole}/plan.json"), format!("{out}/plan.json")).unwrap();
    expect(0, &["run", "--quiet", "--resume", &out]);
    assert_eq!(files(Path::new(&out)), files(Path::new(&whole)));
    let refused = expect(2, &["run", "--resume", &out, "--permutations", "5"]);
    assert!(refused.stderr.contains("cannot be used with"), "{}", refused.stderr);

    let again = at(&folder, "again");
    std::fs::create_dir(&again).unwrap();
    std::fs::copy(format!("{whole}/plan.json"), format!("{again}/plan.json")).unwrap();
    std::fs::write(&expected, "").unwrap();
    let refused = expect(2, &["run", "--resume", &again]);
    assert!(
        refused.stderr.contains("mine-expected.toml: the run was begun with other expectations"),
        "{}",
        refused.stderr
    );
}

/// A worker that somebody kills does not count as a crash of the backend.
#[test]
#[cfg(target_os = "linux")]
fn a_worker_that_somebody_has_ended_is_started_again() {
    use super::driver::children;
    let names: &[&str] = if predicament_effort::whole() { &["KILL", "TERM"] } else { &["KILL"] };
    for &name in names {
        let folder = tempdir().unwrap();
        let suite = write(&folder, "mine.toml", SUITE);
        let out = at(&folder, "run");
        let args = ["run", &suite, "-f", "plain", "-b", "fault:loops", "--isolate", "--timeout", "0.8", "--out", &out];
        let mut child = tool(&args).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        let worker = loop {
            if let Some(worker) = children(child.id()).first().copied() {
                break worker;
            }
            std::thread::sleep(Duration::from_millis(1));
        };
        signal(name, i64::from(worker));
        let code = child.wait().unwrap().code();
        assert_eq!(code, Some(103), "{name}: the scene has run out of time");
        let summary = read(&out, "summary.csv");
        assert_eq!(
            [crate::common::column(&summary, "timeout"), crate::common::column(&summary, "panic")],
            [["1"], ["0"]],
            "{name}"
        );
    }
}

/// A killed download leaves no partial file, and the next download leaves no temporary file.
#[test]
#[cfg(unix)]
fn a_download_that_is_killed_leaves_nothing() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempdir().unwrap();
    let (clients, cache) = (at(&folder, "bin"), at(&folder, "cache"));
    std::fs::create_dir(&clients).unwrap();
    let client = |script: &str| {
        let path = format!("{clients}/npm");
        std::fs::write(&path, format!("#!/bin/sh\n{script}\n")).unwrap();
        std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o755)).unwrap();
    };
    let path = format!("{clients}:{}", std::env::var("PATH").unwrap());
    let manifest = include_str!("../../../../corpora/fetch.toml");
    let entry =
        manifest.split("[[file]]").find(|entry| entry.contains("\"npm\"")).expect("some data is fetched by npm");
    let key = entry.split("key = \"").nth(1).and_then(|rest| rest.split('"').next()).expect("it has a key").to_owned();
    let fetch = || {
        let mut command = tool(&["corpus", "fetch", "--cache", &cache]);
        command.arg(&key).env("PATH", &path).stdout(Stdio::null()).stderr(Stdio::piped());
        command
    };
    client("echo half > package.tgz; exec sleep 30");
    let mut child = fetch();
    std::os::unix::process::CommandExt::process_group(&mut child, 0);
    let mut child = child.spawn().unwrap();
    let litter = || std::fs::read_dir(&cache).map_or(0, |entries| entries.count());
    let written = || {
        let folders = std::fs::read_dir(&cache).into_iter().flatten().flatten();
        folders.map(|folder| folder.path().join("package.tgz")).any(|file| file.exists())
    };
    while !written() {
        assert!(child.try_wait().unwrap().is_none(), "{}", told(child.wait_with_output().unwrap()).stderr);
        std::thread::sleep(Duration::from_millis(1));
    }
    signal("KILL", -i64::from(child.id()));
    child.wait().unwrap();
    assert_eq!(litter(), 1, "the folder of the download");
    client("echo 'npm error there is no network' >&2; exit 1");
    let refused = told(fetch().output().unwrap());
    assert_eq!(refused.code, 104, "{}", refused.stderr);
    assert_eq!(litter(), 0, "it is taken away by the next");
}

/// A file of the user's has the old or the new contents, never a part.
#[test]
#[cfg(target_os = "linux")]
fn a_page_that_a_full_disk_does_not_take_is_the_old_one() {
    if !super::syscalls::can_trace() {
        return;
    }
    let folder = tempdir().unwrap();
    let (out, report) = (at(&folder, "run"), at(&folder, "report"));
    run(&["run", "classics", "-f", "kettner-a1$", "-b", "exact", "--out", &out]);
    let page = write(&folder, "page.md", "mine\n<!-- predicament: glance tables -->\n<!-- /predicament -->\n");
    let before = std::fs::read_to_string(&page).unwrap();
    let tool = tool(&["report", &out, "--splice", &page, "--out", &report]);
    let mut command = std::process::Command::new("strace");
    // The temporary file has its own name and is complete before it replaces the page.
    command.args(["-f", "-q", "-o", "/dev/null", "-P", &page]);
    command.args(["-e", "trace=/^rename", "-e", "inject=/^rename:error=ENOSPC:when=1+"]);
    command.arg(tool.get_program()).args(tool.get_args()).stdin(Stdio::null());
    let told = told(command.output().unwrap());
    assert_eq!(std::fs::read_to_string(&page).unwrap(), before);
    assert_eq!(told.code, 2, "{}{}", told.stdout, told.stderr);
    assert!(told.stderr.contains("page.md: ") && told.stderr.contains("free some space"), "{}", told.stderr);
}
