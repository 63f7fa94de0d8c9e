//! Licences and sources of dependencies, checked by cargo-deny, if installed, with `deny.toml`.

use crate::advisories::locks;
use crate::command::{answers, cargo, root};

/// Checks licences, sources and bans of all workspaces against `deny.toml`; reports if cargo-deny is not installed.
///
/// Advisories are not included: cargo-deny would fetch a database. [`advisories`](crate::advisories) uses a local one.
///
/// # Errors
/// If a dependency has another licence or does not come from the registry.
pub fn check() -> Result<(), String> {
    if !answers("cargo", &["deny", "--version"]) {
        println!(
            "\n== licences and sources of dependencies: NOT RUN: there is no cargo-deny here; type `cargo install --locked \
             cargo-deny`"
        );
        return Ok(());
    }
    let checks = ["licenses", "sources", "bans"];
    // The smaller ones do not use every licence of the list, and only one has fuzz targets.
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
