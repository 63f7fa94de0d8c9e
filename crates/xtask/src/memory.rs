//! The unsafe code of the kernel under checkers of memory: AddressSanitizer, and Miri for what it can interpret.
//!
//! Miri has no registers of AVX-512 and no foreign functions. It runs the tests of `lanes` alone, whose kernels are
//! then compiled for the target's own registers. AddressSanitizer runs all widths that the machine has.

use crate::command::{answers, cargo_command, step, words};

/// The target of builds with a sanitizer: its flags then do not reach build scripts.
const TARGET: &str = "x86_64-unknown-linux-gnu";

/// Runs both checkers; says so where one is missing.
///
/// # Errors
/// If a checker finds something.
pub fn check() -> Result<(), String> {
    let sanitized = if cfg!(all(target_arch = "x86_64", target_os = "linux")) {
        let test = ["test", "--target", TARGET, "--target-dir", "target/sanitized", "--lib"];
        let packages = ["-p", "predicament-lanes", "-p", "predicament-exact"];
        // Stable toolchains come with the sanitizer's runtime, and take its option by this variable alone.
        let flags = [("RUSTC_BOOTSTRAP", "1".to_owned()), ("RUSTFLAGS", "-Zsanitizer=address".to_owned())];
        step("unsafe code under AddressSanitizer", &cargo_command(&[&test[..], &packages].concat()), &flags)
    } else {
        println!("\n== NOT RUN: AddressSanitizer is for {TARGET}");
        Ok(())
    };
    let interpreted = if answers("rustup", &["run", "nightly", "cargo", "miri", "--version"]) {
        let test = ["run", "nightly", "cargo", "miri", "test", "-p", "predicament-lanes", "--lib"];
        let few = [("MIRIFLAGS", "-Zmiri-disable-isolation".to_owned()), ("PROPTEST_CASES", "8".to_owned())];
        step("unsafe code under Miri", &words("rustup", &test), &few)
    } else {
        println!("\n== NOT RUN: there is no Miri here; type `rustup +nightly component add miri`");
        Ok(())
    };
    sanitized.and(interpreted)
}
