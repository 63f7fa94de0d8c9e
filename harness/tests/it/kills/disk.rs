//! On a full disk the tool names the file and the cure; with free space again, the run can be resumed.

use std::path::Path;
use std::process::{Command, Stdio};

use super::driver::{Bench, Shape, differing, files, with_out, words_of};
use crate::common::{expect, told};

/// A shell that runs a script with these arguments.
#[cfg(unix)]
fn shell(script: &str, words: &[&str]) -> Command {
    let mut command = Command::new("sh");
    command.args(["-c", script, "sh"]).args(words).env_remove("PREDICAMENT_CACHE").stdin(Stdio::null());
    command
}

/// The tool and its arguments, as text.
#[cfg(unix)]
fn text_of(words: &[String]) -> Vec<String> {
    let tool = words_of(words);
    std::iter::once(tool.get_program()).chain(tool.get_args()).map(|word| word.to_string_lossy().into_owned()).collect()
}

/// A file size limit exists on every Unix and needs no privileges.
#[test]
#[cfg(unix)]
fn files_that_may_not_grow_are_named_and_the_run_goes_on_when_they_may() {
    let bench = Bench::new(&[Shape::Plain]);
    // The limits are in blocks of 512 bytes; some are too small for the plan, others for a table.
    let limits = if predicament_effort::whole() { vec![0, 1, 2, 4, 8, 12, 16, 24, 32, 64, 128, 256] } else { vec![16] };
    for limit in limits {
        let out = bench.place(&format!("limit {limit}"));
        let words = text_of(&with_out(Shape::Plain.words(), &out));
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let script = format!("ulimit -f {limit}; exec \"$@\"");
        let refused = told(shell(&script, &words).output().unwrap());
        if ![0, 100].contains(&refused.code) {
            let clear = refused.code == 2
                && refused.stderr.contains(&*out.display().to_string())
                && refused.stderr.contains("raise the file size limit");
            assert!(clear, "{limit} blocks: code {}: {}", refused.code, refused.stderr);
        }
        let (was, became) = bench.settle(Shape::Plain, &out, &format!("{limit} blocks"));
        println!("{limit} blocks: code {}; left: {was}; {became}", refused.code);
    }
}

/// An export and a merge that reach the limit name the file too.
#[test]
#[cfg(unix)]
fn exports_and_merges_name_the_file_that_may_not_grow() {
    let bench = Bench::new(&[Shape::Plain]);
    let [out, data, whole] = ["part", "data", "whole"].map(|name| bench.place(name).display().to_string());
    expect(0, &["run", "ties", "-b", "exact", "-q", "--shard", "1/1", "--out", &out]);
    for words in [&["data", "export", &out, "--out", &data][..], &["shard", "merge", &out, "--out", &whole]] {
        let owned = text_of(&words.iter().map(|&word| word.to_owned()).collect::<Vec<_>>());
        let called: Vec<&str> = owned.iter().map(String::as_str).collect();
        let refused = told(shell("ulimit -f 2; exec \"$@\"", &called).output().unwrap());
        let is_clear = refused.stderr.contains("raise the file size limit") && refused.stderr.contains(words[4]);
        assert!(refused.code == 2 && is_clear, "{words:?}: code {}: {}", refused.code, refused.stderr);
        expect(0, words);
    }
}

/// Uses a small file system of its own, in a namespace that ends with the shell, and then resumes with free space.
#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_is_named_and_the_run_goes_on_when_there_is_room() {
    let Some(unshare) = [&["-m"][..], &["-r", "-m"]].into_iter().find(|flags| {
        let tried = Command::new("unshare").args(*flags).args(["mount", "-t", "tmpfs", "tmpfs", "/tmp"]).output();
        tried.is_ok_and(|output| output.status.success())
    }) else {
        println!(
            "NOT TRIED: no file system of one's own can be mounted here; the limits of file sizes are tried instead"
        );
        return;
    };
    let bench = Bench::new(&[Shape::Plain]);
    let sizes = if predicament_effort::whole() { vec![4, 16, 48, 64, 80, 96, 128, 256, 512, 1024] } else { vec![64] };
    let mut refusals = 0;
    for size in sizes {
        let (disk, copy) = (bench.place("disk"), bench.place(&format!("disk {size}")));
        let [disk, copied] = [&disk, &copy].map(|path| path.display().to_string());
        std::fs::create_dir_all(&disk).unwrap();
        let run = Path::new(&disk).join("run");
        let first = text_of(&with_out(Shape::Plain.words(), &run));
        let quoted = |words: &[String]| words.iter().map(|word| format!("'{word}'")).collect::<Vec<_>>().join(" ");
        let resume = ["run", "--quiet", "--resume", &run.display().to_string()].map(str::to_owned);
        let (first, resume) = (quoted(&first), quoted(&text_of(&resume)));
        let plan = run.join("plan.json").display().to_string();
        let script = format!(
            "mount -t tmpfs -o size={size}k tmpfs '{disk}' || exit 90\n{first}; code=$?\n\
             case $code in 0|100) ;; *) mount -o remount,size=64m '{disk}' || exit 91\n\
             if [ -f '{plan}' ]; then {resume}; else {first}; fi; again=$?; echo refused $code then $again;; esac\n\
             cp -a '{}' '{copied}'",
            run.display()
        );
        let told = told(Command::new("unshare").args(unshare).args(["sh", "-c", &script]).output().unwrap());
        assert_eq!(told.code, 0, "{size} KiB: {}{}", told.stdout, told.stderr);
        if told.stdout.contains("refused") {
            refusals += 1;
            assert!(
                told.stdout.contains("refused 2 then 0") || told.stdout.contains("refused 2 then 100"),
                "{}",
                told.stdout
            );
            let clear = told.stderr.contains(&*run.display().to_string()) && told.stderr.contains("free some space");
            assert!(clear, "{size} KiB: {}", told.stderr);
        }
        let differ = differing(&files(&copy), bench.whole(Shape::Plain));
        assert!(differ.is_empty(), "{size} KiB: these files differ: {differ:?}");
        println!(
            "{size} KiB: {}identical",
            told.stdout
                .lines()
                .last()
                .filter(|line| line.starts_with("refused"))
                .map_or(String::new(), |line| format!("{line}; "))
        );
    }
    assert!(refusals > 0, "every disk was large enough");
}
