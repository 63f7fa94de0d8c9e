//! The compiler of `cargo xtask test`: clippy's driver, and rustdoc after it.
//!
//! `cargo clippy`, `cargo test` and `cargo doc` each read every crate again: most of the cost of the first and the last
//! is to read what the tests compile anyway. Clippy's driver is the compiler itself, with lints: it makes the same
//! libraries and tests. So cargo calls this program in the compiler's place (`RUSTC_WORKSPACE_WRAPPER`); this program
//! calls the driver, and rustdoc for each library, with the same arguments. A crate that compiles has neither a warning
//! nor a bad link in its docs. Each crate has a folder of pages, because every call of rustdoc would read and write the
//! search index of a common folder.

use std::ffi::{OsStr, OsString};
use std::path::Path;
use std::process::{Command, ExitCode};

use crate::command::root;

/// The variable with the path of clippy's driver; if it is set, cargo may call this program as a compiler.
const DRIVER: &str = "PREDICAMENT_XTASK_DRIVER";
/// The variable by which `cargo clippy -- -D warnings` passes its arguments to the driver.
const CLIPPY_ARGS: (&str, &str) = ("CLIPPY_ARGS", "-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__");

/// The packages whose integration tests run longer than their optimisation takes.
const OPTIMISED: [&str; 4] = ["predicament-cube-union", "predicament-exact", "predicament-grid", "predicament-sos"];

/// The environment variables that make cargo call this program as its compiler.
///
/// # Errors
/// If clippy is not installed.
pub fn environment() -> Result<Vec<(&'static str, String)>, String> {
    let own = std::env::current_exe().map_err(|error| format!("the path of xtask: {error}"))?;
    let (name, value) = CLIPPY_ARGS;
    Ok(vec![("RUSTC_WORKSPACE_WRAPPER", own.display().to_string()), (DRIVER, driver()?), (name, value.to_owned())])
}

/// The path of the compiler that `cargo clippy` runs, in rustup's folder.
fn driver() -> Result<String, String> {
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    let sysroot = Command::new(&rustc).args(["--print", "sysroot"]).current_dir(root()).output();
    let sysroot = sysroot.map_err(|error| format!("{rustc} did not start: {error}"))?.stdout;
    let bin = Path::new(String::from_utf8_lossy(&sysroot).trim()).join("bin");
    let driver = bin.join("clippy-driver").with_extension(std::env::consts::EXE_EXTENSION);
    if driver.exists() {
        Ok(driver.display().to_string())
    } else {
        Err(format!("clippy is not installed: {} is not there; type `rustup component add clippy`", driver.display()))
    }
}

/// The exit code of the driver and of rustdoc, if cargo calls this program as a compiler with these arguments.
pub fn called(arguments: &[OsString]) -> Option<ExitCode> {
    let driver = std::env::var_os(DRIVER)?;
    // Cargo gives the compiler's name, then options. A chore has neither.
    let options = arguments.get(1)?.to_str()?.starts_with('-').then_some(&arguments[1..])?;
    let package = std::env::var("CARGO_PKG_NAME").unwrap_or_default();
    let unoptimised = is_unoptimised(options, &package).then(|| "-Copt-level=0".into());
    if !runs(&driver, &arguments.iter().cloned().chain(unoptimised).collect::<Vec<_>>()) {
        return Some(ExitCode::FAILURE);
    }
    // The examples are read in source form, and have no pages.
    let pages = if package.starts_with("predicament") { of_rustdoc(options) } else { None };
    let rustdoc = std::env::var_os("RUSTDOC").unwrap_or_else(|| "rustdoc".into());
    let fine = pages.is_none_or(|arguments| runs(&rustdoc, &arguments));
    Some(if fine { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Returns true if this program runs and succeeds.
fn runs(program: &OsStr, arguments: &[OsString]) -> bool {
    match Command::new(program).args(arguments).status() {
        Ok(status) => status.success(),
        Err(error) => {
            eprintln!("xtask: {}: {error}", Path::new(program).display());
            false
        }
    }
}

/// Returns true if these compiler arguments make tests that take longer to optimise than to run.
///
/// A cargo profile has one level per package: for a library that needs optimisation and for its tests.
fn is_unoptimised(arguments: &[OsString], package: &str) -> bool {
    let is_library = arguments.iter().any(|word| word.to_str().is_some_and(|word| word.ends_with("lib.rs")));
    arguments.iter().any(|word| word == "--test") && (is_library || !OPTIMISED.contains(&package))
}

/// The rustdoc arguments for the crate of these compiler arguments, if it is a library.
fn of_rustdoc(arguments: &[OsString]) -> Option<Vec<OsString>> {
    let text: Vec<&str> = arguments.iter().map(|word| word.to_str()).collect::<Option<_>>()?;
    let after = |option: &str| text.iter().position(|&word| word == option).and_then(|at| text.get(at + 1)).copied();
    let name = after("--crate-name")?;
    let is_linked = text.iter().any(|word| word.starts_with("--emit=") && word.contains("link"));
    if !is_linked || after("--crate-type") != Some("lib") || text.contains(&"--test") {
        return None;
    }
    let pages = Path::new(after("--out-dir")?).with_file_name("pages").join(name);
    let mut given = vec!["-o".into(), pages.into(), "-Dwarnings".into()];
    let mut words = text.iter();
    while let Some(&word) = words.next() {
        if ["-C", "--out-dir"].contains(&word) {
            words.next();
        } else if !word.starts_with("-C") && !word.starts_with("--emit=") {
            given.push(word.into());
        }
    }
    Some(given)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(words: &str) -> Option<String> {
        let words: Vec<OsString> = words.split(' ').map(OsString::from).collect();
        let given = of_rustdoc(&words)?.join(OsStr::new(" "));
        Some(given.to_str().expect("text").to_owned())
    }

    #[test]
    fn tests_are_compiled_fast_but_for_those_that_compute() {
        let is =
            |words: &str, package| is_unoptimised(&words.split(' ').map(OsString::from).collect::<Vec<_>>(), package);
        assert!(is("--test src/lib.rs", "predicament-exact") && is("--test tests/it/main.rs", "predicament-hull"));
        assert!(!is("--test tests/it/main.rs", "predicament-exact") && !is("src/lib.rs", "predicament-hull"));
    }

    #[test]
    fn rustdoc_is_called_as_the_compiler_was() {
        let library = "--crate-name hull --edition=2024 src/lib.rs --crate-type lib --emit=dep-info,metadata,link -C \
                       opt-level=1 -Cstrip=debuginfo --warn=missing_docs --out-dir target/ci/deps -L dependency=deps \
                       --extern exact=deps/libexact.rmeta";
        let expected = "-o target/ci/pages/hull -Dwarnings --crate-name hull --edition=2024 src/lib.rs --crate-type lib \
                        --warn=missing_docs -L dependency=deps --extern exact=deps/libexact.rmeta";
        assert_eq!(of(library).as_deref(), Some(expected));
        // These have no pages: a test, an incomplete compilation, a macro, a program, a query of the compiler.
        for (from, to) in [
            ("--crate-type lib", "--test"),
            (",link", ""),
            ("lib --emit", "proc-macro --emit"),
            ("lib --emit", "bin --emit"),
            ("--out-dir", "--print"),
        ] {
            assert_eq!(of(&library.replace(from, to)), None, "{to}");
        }
    }
}
