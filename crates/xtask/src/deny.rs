//! Licences and sources of dependencies, by cargo-deny where it is installed, as `deny.toml` says.

use crate::advisories::locks;
use crate::command::{answers, cargo, root};

/// Holds licences, sources and bans of all workspaces against `deny.toml`; says so where cargo-deny is not installed.
///
/// Advisories are not among them: cargo-deny would fetch a database. [`advisories`](crate::advisories) takes the one that is there.
///
/// # Errors
/// If a dependency has another licence or comes from elsewhere than the registry.
pub fn check() -> Result<(), String> {
    if !answers("cargo", &["deny", "--version"]) {
        println!(
            "\n== licences and sources of dependencies: NOT RUN: there is no cargo-deny here; type `cargo install --locked \
             cargo-deny`"
        );
        return Ok(());
    }
    let checks = ["licenses", "sources", "bans"];
    // The smaller ones do not have every licence of the list, and only one has fuzz targets.
    for (at, lock) in locks(&root())?.iter().enumerate() {
        let manifest = lock.replace("Cargo.lock", "Cargo.toml");
        let graph = ["deny", "--locked", "--manifest-path", &manifest, "--config", "deny.toml"];
        let quiet = ["check", "--hide-inclusion-graph", "-A", "duplicate", "-A", "license-exception-not-encountered"];
        let allowed = if at == 0 { &[][..] } else { &["-A", "license-not-encountered"] };
        let what = format!("licences and sources of dependencies of {manifest}");
        cargo(&what, &[&graph[..], &quiet, allowed, &checks].concat())?;
    }
    Ok(())
}
