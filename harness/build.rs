//! Tells the tool what it was built from and how: the commit, the compiler and its flags, and the version of the crate
//! behind the backend `shewchuk`. All of them belong beside every measurement.
//!
//! The commit and whether the sources differed from it are found out here, not when the tool runs: a tool may run long
//! after its sources have changed. So that neither goes stale, this runs again whenever the checked-out commit changes
//! and whenever one of the files that the tool is built from does, which is when the tool has to be built again
//! anyway. It takes one `git status` and a few calls that are shorter, some hundredths of a second. Tests and pages are
//! not looked at: a change of them makes the tool neither dirty nor built again.

use std::path::{Path, PathBuf};
use std::process::Command;

fn main() {
    // In the workspace the lock file is that of the workspace; in a package it is the package's own.
    let lock =
        ["../Cargo.lock", "Cargo.lock"].into_iter().find(|file| Path::new(file).is_file()).unwrap_or("../Cargo.lock");
    println!("cargo::rerun-if-changed={lock}");
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let version =
        Command::new(rustc).arg("-V").output().map(|out| String::from_utf8_lossy(&out.stdout).trim().to_owned());
    println!("cargo::rustc-env=PREDICAMENT_RUSTC={}", version.unwrap_or_else(|_| "unknown".to_owned()));
    println!("cargo::rustc-env=PREDICAMENT_FLAGS={}", flags());
    commit();
    let lock = std::fs::read_to_string(lock).unwrap_or_default();
    let mut lines = lock.lines().skip_while(|line| *line != "name = \"robust\"");
    let version = lines.nth(1).and_then(|line| line.split('"').nth(1)).unwrap_or("unknown");
    println!("cargo::rustc-env=PREDICAMENT_ROBUST={version}");
}

/// The profile and what was given to the compiler besides. The profile's name stands in the path of the output folder,
/// `target/<profile>/build/<package>/out`; cargo tells it nowhere else.
fn flags() -> String {
    for variable in ["RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS"] {
        println!("cargo::rerun-if-env-changed={variable}");
    }
    let variable = |name: &str| std::env::var(name).unwrap_or_default();
    let out = PathBuf::from(variable("OUT_DIR"));
    let profile = out.ancestors().nth(3).and_then(Path::file_name).and_then(|name| name.to_str()).unwrap_or("unknown");
    let given = variable("CARGO_ENCODED_RUSTFLAGS").replace('\u{1f}', " ");
    let given = if given.is_empty() { "none" } else { &given };
    format!("profile {profile}, the tool's own crate at opt-level {}; RUSTFLAGS: {given}", variable("OPT_LEVEL"))
}

/// The commit, and whether what the tool is built from differs from it. Nothing where there is no git, or where the
/// folder is part of another repository.
fn commit() {
    let sources = sources();
    for path in &sources {
        println!("cargo::rerun-if-changed=../{path}");
    }
    if git(&["rev-parse", "--show-prefix"]).as_deref() != Some("harness/") {
        return;
    }
    // The log of HEAD grows with each commit, also where the branch has no file of its own yet.
    let mut watched = ["HEAD", "logs/HEAD", "packed-refs"].map(str::to_owned).to_vec();
    watched.extend(git(&["symbolic-ref", "--quiet", "HEAD"]));
    for path in watched.iter().filter_map(|name| git(&["rev-parse", "--git-path", name])) {
        // A file that isn't there would have this run every time.
        if Path::new(&path).exists() {
            println!("cargo::rerun-if-changed={path}");
        }
    }
    let Some(commit) = git(&["rev-parse", "HEAD"]) else { return };
    println!("cargo::rustc-env=PREDICAMENT_COMMIT={commit}");
    let from_the_top: Vec<String> = sources.iter().map(|path| format!(":/{path}")).collect();
    let mut status = vec!["--no-optional-locks", "status", "--porcelain", "--"];
    status.extend(from_the_top.iter().map(String::as_str));
    if let Some(changes) = git(&status) {
        println!("cargo::rustc-env=PREDICAMENT_DIRTY={}", !changes.is_empty());
    }
}

/// The files and folders that the tool is built from, from the top of the repository.
fn sources() -> Vec<String> {
    let mut sources: Vec<String> = [
        "Cargo.toml",
        "Cargo.lock",
        "corpora",
        "harness/Cargo.toml",
        "harness/build.rs",
        "harness/src",
        "harness/templates",
        // What is behind the links in the templates. The folders have also what running the helpers leaves there.
        "engines/include/predicament_engine.hpp",
        "engines/node/predicament_engine.mjs",
        "engines/python/predicament_engine.py",
        "engines/rust/src",
    ]
    .map(str::to_owned)
    .into();
    // Crates stand in groups, each a folder.
    for one in folders("crates").into_iter().flat_map(|group| folders(&group).into_iter().chain([group])) {
        let parts = ["Cargo.toml", "build.rs", "src", "templates"].map(|part| format!("{one}/{part}"));
        sources.extend(parts);
    }
    sources.retain(|path| Path::new("..").join(path).exists());
    sources.sort();
    sources
}

/// The folders in a folder, from the top of the repository.
fn folders(of: &str) -> Vec<String> {
    let entries = std::fs::read_dir(Path::new("..").join(of)).into_iter().flatten().flatten();
    let folders = entries.filter(|entry| entry.path().is_dir());
    folders.filter_map(|entry| Some(format!("{of}/{}", entry.file_name().into_string().ok()?))).collect()
}

/// The output of git, without the end of the line; `None` if git fails or is missing.
fn git(args: &[&str]) -> Option<String> {
    let output = Command::new("git").args(args).output().ok().filter(|output| output.status.success())?;
    String::from_utf8(output.stdout).ok().map(|text| text.trim_end().to_owned())
}
