//! The fuzz targets, each for ten minutes, as many at a time as there are cores.

use std::ffi::OsStr;
use std::num::NonZero;
use std::sync::Mutex;

use crate::command::{Beside, answers, cargo, root, step, words};

/// The duration of each fuzz target in seconds, on one core.
const SECONDS: u32 = 600;
/// Every command of cargo-fuzz starts so.
const TOOL: [&str; 4] = ["run", "nightly", "cargo", "fuzz"];

/// Runs every fuzz target for a while, starting from the scenes of the embedded suites.
///
/// # Errors
/// If there is no cargo-fuzz, a target does not build, or a target finds something.
pub fn check() -> Result<(), String> {
    if !answers("rustup", &[&TOOL[..], &["--version"]].concat()) {
        return Err("fuzzing needs a nightly toolchain and cargo-fuzz, so nothing was fuzzed; type `rustup toolchain \
                    install nightly` and `cargo install cargo-fuzz`"
            .to_owned());
    }
    let targets = targets()?;
    let manifest = ["--release", "--manifest-path", "fuzz/Cargo.toml"];
    let mut failed = Vec::new();
    failed.extend(cargo("tests of the fuzz targets", &[&["test"], &manifest[..]].concat()).err());
    failed.extend(seeds().err());
    step("build the fuzz targets", &words("rustup", &[&TOOL[..], &["build", "--fuzz-dir", "fuzz"]].concat()), &[])?;
    let cores = std::thread::available_parallelism().map_or(1, NonZero::get);
    let (waiting, found) = (Mutex::new(targets.iter()), Mutex::new(Vec::new()));
    std::thread::scope(|scope| {
        for _ in 0..cores {
            scope.spawn(|| {
                while let Some(target) = next(&waiting) {
                    if let Err(why) = fuzz(target) {
                        found.lock().unwrap_or_else(std::sync::PoisonError::into_inner).push(why);
                    }
                }
            });
        }
    });
    let mut found = found.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    found.sort();
    failed.extend(found);
    if failed.is_empty() { Ok(()) } else { Err(failed.join("; ")) }
}

/// The names of all targets, sorted.
fn targets() -> Result<Vec<String>, String> {
    let folder = root().join("fuzz/fuzz_targets");
    let mut targets = Vec::new();
    for entry in std::fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))? {
        let path = entry.map_err(|error| format!("{}: {error}", folder.display()))?.path();
        targets.extend(path.file_stem().and_then(OsStr::to_str).map(str::to_owned));
    }
    targets.sort();
    if targets.is_empty() { Err(format!("{} has no fuzz targets", folder.display())) } else { Ok(targets) }
}

/// The next target, if any is left.
fn next<'a>(waiting: &Mutex<std::slice::Iter<'a, String>>) -> Option<&'a String> {
    waiting.lock().unwrap_or_else(std::sync::PoisonError::into_inner).next()
}

fn fuzz(target: &str) -> Result<(), String> {
    let seconds = format!("-max_total_time={SECONDS}");
    let run = [&TOOL[..], &["run", "--fuzz-dir", "fuzz", target, "--", &seconds, "-timeout=120"]].concat();
    let ended = Beside::start(&format!("fuzz {target}"), &words("rustup", &run), &[]).and_then(Beside::finish);
    ended.map_err(|why| {
        format!(
            "{why}; `cargo run --release --manifest-path fuzz/Cargo.toml --example find -- {target} \
             fuzz/artifacts/{target}/FILE NAME` prints the find as a scene"
        )
    })
}

/// Writes the seeds of fuzzing, from the embedded suites, into `fuzz/corpus`.
///
/// # Errors
/// If the program of seeds does not build, or fails.
pub fn seeds() -> Result<(), String> {
    let run = ["run", "--quiet", "--release", "--manifest-path", "fuzz/Cargo.toml", "--example", "seeds"];
    cargo("seeds of the fuzz targets", &run)
}
