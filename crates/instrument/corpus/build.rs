//! Rebuilds the crate when a suite changes: the corpora are embedded, and the compiler does not detect files that are
//! added to or removed from a folder.

fn main() {
    println!("cargo::rerun-if-changed=../../../corpora");
}
