//! Says whether backends share one compilation of the tasks.
//!
//! Times are published of optimised builds, in which each task is compiled for each backend. That is most of what this crate costs to
//! compile, and of no use to a build that nobody times: there all backends go behind a pointer (`boxed.rs`).

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(shared_tasks)");
    let level = std::env::var("OPT_LEVEL").unwrap_or_default();
    if level == "0" || level == "1" {
        println!("cargo::rustc-cfg=shared_tasks");
    }
}
