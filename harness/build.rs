//! Tells the tool which compiler made it and which versions of other people's
//! crates it compares with: both belong beside every measurement.

use std::process::Command;

/// The peers, as packages.
const PEERS: [&str; 8] =
    ["delaunay", "geo", "geogram_predicates", "geometry-predicates", "rgeometry", "robust", "rstar", "simplicity"];

fn main() {
    println!("cargo::rerun-if-changed=../Cargo.lock");
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let version =
        Command::new(rustc).arg("-V").output().map(|out| String::from_utf8_lossy(&out.stdout).trim().to_owned());
    println!("cargo::rustc-env=PREDICAMENT_RUSTC={}", version.unwrap_or_else(|_| "unknown".to_owned()));
    let lock = std::fs::read_to_string("../Cargo.lock").unwrap_or_default();
    for peer in PEERS {
        let mut lines = lock.lines().skip_while(|line| *line != format!("name = \"{peer}\""));
        let version = lines.nth(1).and_then(|line| line.split('"').nth(1)).unwrap_or("unknown");
        let variable = peer.to_uppercase().replace('-', "_");
        println!("cargo::rustc-env=PREDICAMENT_{variable}={version}");
    }
}
