//! The steps of each chore, shown as they start.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

/// Where `demo` leaves its work, beside the build.
const DEMO: &str = "target/demo";
/// Where `test` leaves its run.
const GATE: &str = "target/gate";

/// Builds the tool, runs and times the embedded corpora, writes the report.
pub fn demo() -> Result<(), String> {
    let demo = fresh(DEMO)?;
    let path = |name: &str| demo.join(name).display().to_string();
    let (run, bench, report) = (path("run"), path("bench"), path("report"));
    cargo("build the tool", &["build", "--release"])?;
    tool("run the embedded corpora", &["run", "--out", &run])?;
    tool("time the backends", &["bench", "--out", &bench])?;
    tool("write the report", &["report", &run, &bench, "--out", &report])?;
    println!("\nOpen {report}/report.html");
    Ok(())
}

/// Everything that has to pass before a change lands.
pub fn test() -> Result<(), String> {
    let gate = fresh(GATE)?.join("run").display().to_string();
    cargo("format", &["fmt", "--all", "--check"])?;
    cargo("clippy", &["clippy", "--release", "--workspace", "--all-targets", "--", "-D", "warnings"])?;
    cargo("tests and doc tests", &["test", "--release", "--workspace", "--no-fail-fast"])?;
    with_env("docs", "RUSTDOCFLAGS", "-D warnings", &["doc", "--release", "--workspace", "--no-deps"])?;
    cargo("build the tool", &["build", "--release"])?;
    tool("verify the corpora", &["corpus", "verify"])?;
    tool("run the embedded corpora", &["run", "--level", "quick", "--out", &gate])?;
    tool("hold the run against its expectations", &["gate", &gate])?;
    tool("see that planted faults are caught", &["selftest"])
}

fn root() -> PathBuf {
    // xtask lives in crates/xtask of the workspace that it serves.
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn fresh(dir: &str) -> Result<PathBuf, String> {
    let full = root().join(dir);
    if full.exists() {
        std::fs::remove_dir_all(&full).map_err(|error| format!("{}: {error}", full.display()))?;
    }
    std::fs::create_dir_all(&full).map_err(|error| format!("{}: {error}", full.display()))?;
    Ok(PathBuf::from(dir))
}

fn cargo(what: &str, args: &[&str]) -> Result<(), String> {
    with_env(what, "CARGO_TERM_PROGRESS_WHEN", "auto", args)
}

fn tool(what: &str, args: &[&str]) -> Result<(), String> {
    let all: Vec<&str> =
        ["run", "--quiet", "--release", "--bin", "predicament", "--"].into_iter().chain(args.iter().copied()).collect();
    cargo(what, &all)
}

fn with_env(what: &str, key: &str, value: &str, args: &[&str]) -> Result<(), String> {
    println!("\n== {what}: cargo {}", args.join(" "));
    let start = Instant::now();
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status = Command::new(cargo)
        .args(args)
        .env(key, value)
        .current_dir(root())
        .status()
        .map_err(|error| format!("{what}: cargo did not start: {error}"))?;
    if status.success() {
        println!("== {what}: ok, {:.0} s", start.elapsed().as_secs_f64());
        Ok(())
    } else {
        Err(format!("{what} failed: {status}"))
    }
}
