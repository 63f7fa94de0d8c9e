//! The steps of each chore.

use std::ffi::OsStr;
use std::path::Path;

use crate::command::{Beside, answers, cargo, cargo_command, fresh, root, step, target_directory, words};
use crate::{c_library, compiler};

/// The folder of `demo`. Cargo has `target/demo`, the build of the profile.
const DEMO: &str = "target/demo-report";
/// The folder of the run of `test`.
const GATE: &str = "target/gate";
/// The crates that use the tool as a library.
///
/// In the workspace they share its builds; `nightly` builds them outside, as a user would.
const EXAMPLES: [&str; 5] = ["leftmost", "convexity", "mine", "own-predicate", "regular"];
/// The package of benches.
///
/// It has no tests, and its dependencies would be compiled or checked for them: `nightly` does that.
const BENCHES: &str = "predicament-benches";
/// The variable that sets the effort of heavy tests, as the crate `effort` reads it.
const EFFORT: (&str, &str) = ("PREDICAMENT_EFFORT", "whole");
/// The duration of each fuzz target in seconds, on one core.
const FUZZ_SECONDS: u32 = 600;

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
fn ignored_tests(what: &str, tests: &[&str], env: &[(&str, String)]) -> Result<(), String> {
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

/// Builds the engines of published crates, starts them, and checks the pages about them.
fn crates() -> Result<(), String> {
    let locks = crate::advisories::locks(&root())?;
    let folders = locks.iter().filter_map(|lock| lock.strip_prefix("engines/")?.strip_suffix("/Cargo.lock"));
    let mut names: Vec<&str> = folders.filter(|name| *name != "rust").collect();
    for name in &names {
        let manifest = format!("engines/{name}/Cargo.toml");
        let with =
            ["--release", "--locked", "--manifest-path", &manifest, "--target-dir", &format!("engines/{name}/target")];
        cargo(&format!("format of the engine {name}"), &["fmt", "--manifest-path", &manifest, "--check"])?;
        let lint = [&["clippy", "--all-targets"], &with[..], &["--", "-D", "warnings"]].concat();
        cargo(&format!("clippy of the engine {name}"), &lint)?;
        cargo(&format!("tests of the engine {name}"), &[&["test"], &with[..]].concat())?;
    }
    // These are built in the folders of others.
    names.extend(["delaunay-sorted", "geogram-predicates-sos"]);
    for chore in ["install", "build", "check"] {
        let run = ["run", "--quiet", "--profile", "ci", "--", "engines", chore];
        cargo(&format!("{chore} engines of crates"), &[&run[..], &names].concat())?;
    }
    ignored_tests("engines of crates", &["of_crates"], &[])
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
fn run_tests(what: &str, env: &[(&str, String)]) -> Result<Option<Beside>, String> {
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

/// Runs the checks that take too long for every change, or need more than a Rust toolchain.
///
/// It continues after a failure, and fails if a check failed or could not run.
pub fn nightly() -> Result<(), String> {
    let with_peers = ["--profile", "ci", "--workspace", "--features", "predicament-benches/peers"];
    let lint = [&["clippy", "--all-targets"], &with_peers[..], &["--", "-D", "warnings"]].concat();
    let done = [
        cargo("clippy, with the peers of benches", &lint),
        // The table about wrong answers of crates is checked against the published fixtures.
        cargo("fetch data", &["run", "--quiet", "--profile", "ci", "--", "corpus", "fetch"]),
        run_tests("tests", &[(EFFORT.0, EFFORT.1.to_owned())]).and_then(|docs| docs.map_or(Ok(()), Beside::finish)),
        cargo(
            "the header of the C library",
            &["test", "--profile", "ci", "-p", "predicament-c", "--features", "header", "header"],
        ),
        cargo(
            "the C library without ties that are broken",
            &["check", "--profile", "ci", "-p", "predicament-c", "--no-default-features"],
        ),
        crates(),
        cargo("build the benches", &[&["bench", "--benches", "--no-run"], &with_peers[..]].concat()),
        packages(),
        crate::prove::check(),
        crate::memory::check(),
        crate::defects::check(),
        crate::deny::check(),
        crate::advisories::check_if_at_hand(),
        crate::ci_page::check(),
        crate::book::build_if_at_hand(),
        crate::browser::check(true, false),
        crate::data::check(),
        crate::python::wheel(),
        crate::vectors::check_with_peers(),
        crate::spread::check(),
        minimum_version(),
        strangers(),
        fuzz(),
    ];
    let failed: Vec<String> = done.into_iter().filter_map(Result::err).collect();
    if failed.is_empty() { Ok(()) } else { Err(failed.join("\nxtask: ")) }
}

/// Packages what goes to a registry, and compiles each package as somebody else's, in a folder of its own.
fn packages() -> Result<(), String> {
    let others = EXAMPLES.into_iter().chain([
        BENCHES,
        "predicament-effort",
        "predicament-proofs",
        "predicament-python",
        "xtask",
    ]);
    let excluded: Vec<&str> = others.flat_map(|name| ["--exclude", name]).collect();
    let package = ["package", "--workspace", "--allow-dirty", "--target-dir", "target/package-check"];
    cargo("packages", &[&package[..], &excluded].concat())
}

/// Checks the workspace by the oldest compiler that it promises to build with.
fn minimum_version() -> Result<(), String> {
    let version = env!("CARGO_PKG_RUST_VERSION");
    if !answers("rustup", &["run", version, "cargo", "--version"]) {
        return Err(format!(
            "Rust {version} is not installed, so nothing was checked with it; type `rustup toolchain install {version}`"
        ));
    }
    let check = ["run", version, "cargo", "check", "--workspace", "--all-targets", "--target-dir", "target/msrv"];
    step(&format!("check with Rust {version}"), &words("rustup", &check), &[])
}

/// Runs the tests of the examples in separate folders, each a workspace as in a user's repository.
fn strangers() -> Result<(), String> {
    let folder = fresh("target/strangers")?;
    let here = format!("\"{}/", root().display());
    let mut failed = Vec::new();
    for name in EXAMPLES {
        let (from, to) = (root().join("examples").join(name), root().join(&folder).join(name));
        copy(&from, &to).map_err(|error| format!("{}: {error}", from.display()))?;
        let manifest = to.join("Cargo.toml");
        let text = std::fs::read_to_string(&manifest).map_err(|error| format!("{}: {error}", manifest.display()))?;
        let alone = text.replace("\"../../", &here) + "\n[workspace]\n\n[profile.dev.package.\"*\"]\nopt-level = 1\n";
        std::fs::write(&manifest, alone).map_err(|error| format!("{}: {error}", manifest.display()))?;
        let manifest = manifest.display().to_string();
        // One folder for all, since they share dependencies.
        let target = root().join(&folder).join("target").display().to_string();
        let test = ["test", "--manifest-path", &manifest, "--target-dir", &target];
        failed.extend(cargo(&format!("tests of {name} as a crate of its own"), &test).err());
    }
    if failed.is_empty() { Ok(()) } else { Err(failed.join("; ")) }
}

/// Copies a folder with its contents.
fn copy(from: &Path, to: &Path) -> std::io::Result<()> {
    std::fs::create_dir_all(to)?;
    for entry in std::fs::read_dir(from)? {
        let entry = entry?;
        let (path, to) = (entry.path(), to.join(entry.file_name()));
        if path.is_dir() { copy(&path, &to)? } else { std::fs::copy(&path, &to).map(|_| ())? }
    }
    Ok(())
}

/// Runs every fuzz target for a while, starting from the scenes of the embedded suites.
fn fuzz() -> Result<(), String> {
    if !answers("rustup", &["run", "nightly", "cargo", "fuzz", "--version"]) {
        return Err("fuzzing needs a nightly toolchain and cargo-fuzz, so nothing was fuzzed; type `rustup toolchain \
                    install nightly` and `cargo install cargo-fuzz`"
            .to_owned());
    }
    let mut targets = Vec::new();
    let folder = root().join("fuzz/fuzz_targets");
    for entry in std::fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))? {
        let path = entry.map_err(|error| format!("{}: {error}", folder.display()))?.path();
        targets.extend(path.file_stem().and_then(OsStr::to_str).map(str::to_owned));
    }
    targets.sort();
    let seconds = format!("-max_total_time={FUZZ_SECONDS}");
    let mut failed = Vec::new();
    let manifest = ["--release", "--manifest-path", "fuzz/Cargo.toml"];
    failed.extend(cargo("tests of the fuzz targets", &[&["test"], &manifest[..]].concat()).err());
    failed.extend(fuzz_seeds().err());
    for target in &targets {
        let run =
            ["run", "nightly", "cargo", "fuzz", "run", "--fuzz-dir", "fuzz", target, "--", &seconds, "-timeout=120"];
        let found = step(&format!("fuzz {target}"), &words("rustup", &run), &[]).err();
        failed.extend(found.map(|why| {
            format!(
                "{why}; `cargo run --release --manifest-path fuzz/Cargo.toml --example find -- {target} \
                 fuzz/artifacts/{target}/FILE NAME` prints the find as a scene"
            )
        }));
    }
    if targets.is_empty() {
        return Err(format!("{} has no fuzz targets", folder.display()));
    }
    if failed.is_empty() { Ok(()) } else { Err(failed.join("; ")) }
}

/// Writes the seeds of fuzzing, from the embedded suites, into `fuzz/corpus`.
pub fn fuzz_seeds() -> Result<(), String> {
    let run = ["run", "--quiet", "--release", "--manifest-path", "fuzz/Cargo.toml", "--example", "seeds"];
    cargo("seeds of the fuzz targets", &run)
}
