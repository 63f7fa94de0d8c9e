//! Rebuilds the crate when a suite changes: the corpora are embedded, and the
//! compiler doesn't see files that come and go in a folder.

fn main() {
    println!("cargo::rerun-if-changed=../../../corpora");
}
