//! Names of families that were timed on several threads.

/// The name of a family that was timed on a number of threads.
#[must_use]
pub fn on_threads(family: &str, threads: usize) -> String {
    if threads == 1 { family.to_owned() } else { format!("{family} on {threads} threads") }
}
