//! Decides whether backends share one compilation of the tasks.
//!
//! Times are published for optimised builds, in which each task is compiled for each backend. These compilations are
//! most of this crate's build time, and untimed builds do not need them: there all backends are behind a pointer
//! (`boxed.rs`).

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(shared_tasks)");
    let level = std::env::var("OPT_LEVEL").unwrap_or_default();
    if level == "0" || level == "1" {
        println!("cargo::rustc-cfg=shared_tasks");
    }
}
