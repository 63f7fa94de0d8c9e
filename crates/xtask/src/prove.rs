//! `cargo xtask prove`: the constants of filters and the bounds of tolerances, proved by Gappa, and partly by Coq.

use crate::command::{cargo, fresh};

/// The folder of the scripts.
const FOLDER: &str = "target/proofs";

/// Proves everything, and prints the tables; says so where there is no `gappa`.
pub fn check() -> Result<(), String> {
    let folder = fresh(FOLDER)?.display().to_string();
    let prove = ["run", "--quiet", "--profile", "ci", "-p", "predicament-proofs", "--bin", "prove", "--", &folder];
    cargo("prove the constants", &prove)
}
