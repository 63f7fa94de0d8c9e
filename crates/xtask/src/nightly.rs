//! The checks that take too long for every change, or need more than a Rust toolchain.
//!
//! They are a list of named steps. A step that failed can be run again alone, and several machines can share them.

use std::path::Path;
use std::time::Instant;

use crate::command::{Beside, answers, cargo, fresh, root, step, words};
use crate::steps::{BENCHES, ignored_tests, run_tests};

/// The crates that use the tool as a library.
///
/// In the workspace they share its builds; `nightly` builds them outside, as a user would.
const EXAMPLES: [&str; 5] = ["leftmost", "convexity", "mine", "own-predicate", "regular"];
/// The variable that sets the effort of heavy tests, as the crate `effort` reads it.
const EFFORT: (&str, &str) = ("PREDICAMENT_EFFORT", "whole");
/// Every crate, with the peers of benches.
const WITH_PEERS: [&str; 5] = ["--profile", "ci", "--workspace", "--features", "predicament-benches/peers"];

/// A name, and the function that does the step.
type Step = (&'static str, fn() -> Result<(), String>);

const STEPS: [Step; 21] = [
    ("lint", lint),
    ("tests", tests),
    ("c-features", c_features),
    ("engines", engines),
    ("benches", benches),
    ("packages", packages),
    ("prove", crate::prove::check),
    ("memory", crate::memory::check),
    ("defects", crate::defects::check),
    ("licences", crate::deny::check),
    ("advisories", crate::advisories::check_if_at_hand),
    ("ci-page", crate::ci_page::check),
    ("book", crate::book::build_if_at_hand),
    ("browser", browser),
    ("data", crate::data::check),
    ("wheel", crate::python::wheel),
    ("vectors", crate::vectors::check_with_peers),
    ("spread", crate::spread::check),
    ("oldest-compiler", minimum_version),
    ("strangers", strangers),
    ("fuzz", crate::fuzz::check),
];

/// Runs the named steps, or all; prints how each ended and how long it took.
///
/// It continues after a failure.
///
/// # Errors
/// If a name is unknown, or a step failed or could not run.
pub fn check(names: &[String]) -> Result<(), String> {
    if let Some(strange) = names.iter().find(|name| STEPS.iter().all(|step| step.0 != **name)) {
        let known: Vec<&str> = STEPS.iter().map(|step| step.0).collect();
        return Err(format!("no step of nightly is called `{strange}`; there are {}", known.join(", ")));
    }
    let is_asked = |step: &&Step| names.is_empty() || names.iter().any(|name| name == step.0);
    let (mut table, mut failed) = (String::new(), Vec::new());
    for &(name, run) in STEPS.iter().filter(is_asked) {
        let start = Instant::now();
        let done = run();
        let end = if done.is_ok() { "done" } else { "FAILED" };
        table += &format!("{name:<16} {end:<6} {:>6.0} s\n", start.elapsed().as_secs_f64());
        failed.extend(done.err().map(|why| format!("{name}: {why}")));
    }
    println!("\n{table}");
    if failed.is_empty() { Ok(()) } else { Err(failed.join("\nxtask: ")) }
}

fn lint() -> Result<(), String> {
    cargo(
        "clippy, with the peers of benches",
        &[&["clippy", "--all-targets"], &WITH_PEERS[..], &["--", "-D", "warnings"]].concat(),
    )
}

/// Runs every test in full, after the data that the table about wrong answers of crates is checked against.
fn tests() -> Result<(), String> {
    let fetched = cargo("fetch data", &["run", "--quiet", "--profile", "ci", "--", "corpus", "fetch"]);
    let tested = run_tests("tests", &[(EFFORT.0, EFFORT.1.to_owned())]);
    fetched.and(tested.and_then(|docs| docs.map_or(Ok(()), Beside::finish)))
}

fn c_features() -> Result<(), String> {
    let header = ["test", "--profile", "ci", "-p", "predicament-c", "--features", "header", "header"];
    cargo("the header of the C library", &header)?;
    let bare = ["check", "--profile", "ci", "-p", "predicament-c", "--no-default-features"];
    cargo("the C library without ties that are broken", &bare)
}

fn benches() -> Result<(), String> {
    cargo("build the benches", &[&["bench", "--benches", "--no-run"], &WITH_PEERS[..]].concat())
}

fn browser() -> Result<(), String> {
    crate::browser::check(true, false)
}

/// Builds the engines of published crates, starts them, and checks the pages about them.
fn engines() -> Result<(), String> {
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
