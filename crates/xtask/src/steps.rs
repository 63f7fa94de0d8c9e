//! The steps of each chore.

use crate::command::{Beside, answers, cargo, cargo_command, fresh, root, step, target_directory, words};
use crate::{c_library, compiler};

/// The folder of `demo`. Cargo has `target/demo`, the build of the profile.
const DEMO: &str = "target/demo-report";
/// The folder of the run of `test`.
const GATE: &str = "target/gate";
/// The package of benches.
///
/// It has no tests, and its dependencies would be compiled or checked for them: `nightly` does that.
pub const BENCHES: &str = "predicament-benches";

/// Builds the tool, runs and times the embedded corpora, writes the report.
pub fn demo() -> Result<(), String> {
    let demo = fresh(DEMO)?;
    let path = |name: &str| demo.join(name).display().to_string();
    let (run, bench, report) = (path("run"), path("bench"), path("report"));
    cargo("build the tool", &["build", "--profile", "demo"])?;
    let tool = |what: &str, args: &[&str]| {
        let all = ["run", "--quiet", "--profile", "demo", "--bin", "predicament", "--"];
        cargo(what, &all.iter().chain(args).copied().collect::<Vec<_>>())
    };
    tool("run the embedded corpora", &["run", "--out", &run])?;
    tool("time the backends", &["bench", "--judged", &run, "--seconds", "30", "--out", &bench])?;
    tool("write the report", &["report", &run, &bench, "--out", &report])?;
    println!("\nOpen {report}/report.html");
    Ok(())
}

/// Runs everything that must pass before a change lands.
///
/// There is one profile and one build ([`compiler`]): the binary that the tests have used also runs the corpora. Steps
/// that leave cores idle run beside others.
pub fn test() -> Result<(), String> {
    cargo("format", &["fmt", "--all", "--check"])?;
    let compiler = compiler::environment()?;
    let doc_tests = run_tests("clippy, docs and tests", &compiler)?;
    // As other libraries get it: without the features that this workspace turns on.
    for features in ["", "scenes"] {
        let alone =
            ["check", "--profile", "ci", "-p", "predicament-exact", "--no-default-features", "--features", features];
        cargo("the exact kernel without the standard library", &alone)?;
    }
    let planted = selftest()?;
    let in_python = crate::python::start()?;
    engine_examples(&compiler)?;
    crate::vectors::check()?;
    c_library::check()?;
    gate()?;
    planted.finish()?;
    in_python.map_or(Ok(()), Beside::finish)?;
    doc_tests.map_or(Ok(()), Beside::finish)
}

/// Runs format, clippy, docs and the tests of these crates alone, named by folder: `delaunay`, `exact`; for `python`
/// also the tests in Python.
pub fn test_of(crates: &[String]) -> Result<(), String> {
    let folders = ["kernel", "instrument", "systems", "lab", "bindings"].map(|group| root().join("crates").join(group));
    let is_one = |name: &String| folders.iter().any(|group| group.join(name).join("Cargo.toml").is_file());
    if let Some(strange) = crates.iter().find(|name| !is_one(name)) {
        return Err(format!("no crate is called `{strange}`: name a folder of crates/*, such as `delaunay`"));
    }
    let packages: Vec<String> =
        crates.iter().flat_map(|name| ["-p".to_owned(), format!("predicament-{name}")]).collect();
    let with = |words: &[&str], end: &[&str]| {
        let words = words.iter().map(|&word| word.to_owned()).chain(packages.iter().cloned());
        cargo_command(&words.chain(end.iter().map(|&word| word.to_owned())).collect::<Vec<_>>())
    };
    step("format", &with(&["fmt", "--check"], &[]), &[])?;
    step("clippy, docs, tests and doc tests", &with(&["test", "--profile", "ci"], &[]), &compiler::environment()?)?;
    let is_python = crates.iter().any(|name| name == "python");
    let in_python = if is_python { crate::python::start()? } else { None };
    in_python.map_or(Ok(()), Beside::finish)
}

/// Runs the tests of engines for each installed language; prints which do not run.
fn engine_examples(compiler: &[(&str, String)]) -> Result<(), String> {
    let helper = ["--locked", "--target-dir", "target/engine-helper", "--manifest-path", "engines/rust/Cargo.toml"];
    cargo("format of engines in Rust", &["fmt", "--manifest-path", "engines/rust/Cargo.toml", "--check"])?;
    let tests = cargo_command(&[&["test"], &helper[..]].concat());
    step("clippy, docs and tests of the helper in Rust", &tests, compiler)?;
    let languages = [
        ("C++", "c++", "in_cpp"),
        ("Python", "python3", "in_python"),
        ("Rust", "cargo", "in_rust"),
        ("JavaScript", "node", "in_node"),
    ];
    let (there, missing): (Vec<_>, Vec<_>) =
        languages.into_iter().partition(|(_, program, _)| answers(program, &["--version"]));
    for (language, program, _) in missing {
        println!("\n== engine in {language}: NOT RUN: there is no `{program}` here");
    }
    let tests: Vec<&str> = there.into_iter().map(|(_, _, tests)| tests).collect();
    ignored_tests("engines in C++, Python, Rust and JavaScript", &tests, compiler)
}

/// Runs the ignored tests whose names contain one of these words.
pub fn ignored_tests(what: &str, tests: &[&str], env: &[(&str, String)]) -> Result<(), String> {
    // The same packages as before: one alone has other features, and GMP would be built again.
    let packages = ["--workspace", "--exclude", BENCHES, "--test", "it"];
    let run = if has_nextest() {
        // It starts those that it is asked for, and no test binary for nothing.
        [&["nextest", "run", "--cargo-profile", "ci"][..], &packages, &["--run-ignored", "only"], tests].concat()
    } else {
        [&["test", "--profile", "ci"][..], &packages, &["--", "--ignored"], tests].concat()
    };
    step(what, &cargo_command(&run), env)
}

/// Installs and builds the engines that come with the project, by the clients of their registries.
///
/// It takes the named engines, or all.
pub fn engines(names: &[String]) -> Result<(), String> {
    cargo("build the tool", &["build", "--release"])?;
    let mut failed = Vec::new();
    for chore in ["install", "build", "check"] {
        let run = ["run", "--quiet", "--release", "--bin", "predicament", "--", "engines", chore];
        let words: Vec<&str> = run.into_iter().chain(names.iter().map(String::as_str)).collect();
        failed.extend(cargo(&format!("{chore} engines"), &words).err());
    }
    if failed.is_empty() { Ok(()) } else { Err(failed.join("; ")) }
}

/// Runs the tests, by nextest if it is installed, as it starts the tests of all crates at once.
///
/// Doc tests are then a step of their own, which runs beside the next steps.
pub fn run_tests(what: &str, env: &[(&str, String)]) -> Result<Option<Beside>, String> {
    if has_nextest() {
        let run = ["nextest", "run", "--cargo-profile", "ci", "--workspace", "--exclude", BENCHES, "--no-fail-fast"];
        step(what, &cargo_command(&run), env)?;
        let docs = ["test", "--profile", "ci", "--workspace", "--exclude", BENCHES, "--doc"];
        Beside::start("doc tests", &cargo_command(&docs), env).map(Some)
    } else {
        let test = ["test", "--profile", "ci", "--workspace", "--exclude", BENCHES, "--no-fail-fast"];
        step(&format!("{what}, doc tests"), &cargo_command(&test), env).map(|()| None)
    }
}

fn has_nextest() -> bool {
    answers("cargo", &["nextest", "--version"])
}

/// The command line of the tool that was tested.
fn tool(args: &[&str]) -> Result<Vec<String>, String> {
    Ok(words(&target_directory()?.join("ci").join("predicament").display().to_string(), args))
}

/// The planted faults.
fn selftest() -> Result<Beside, String> {
    Beside::start("see that planted faults are caught", &tool(&["setup", "selftest"])?, &[])
}

/// The corpora, and the embedded run against its expectations.
fn gate() -> Result<(), String> {
    let run = fresh(GATE)?.join("run").display().to_string();
    step("verify the corpora", &tool(&["corpus", "verify"])?, &[])?;
    step("run the embedded corpora", &tool(&["run", "--level", "quick", "--out", &run])?, &[])?;
    step("hold the run against its expectations", &tool(&["gate", &run])?, &[])
}
