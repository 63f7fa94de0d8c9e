//! Families that were timed on several threads.

/// What a family is called where it was timed on so many threads.
#[must_use]
pub fn on_threads(family: &str, threads: usize) -> String {
    if threads == 1 { family.to_owned() } else { format!("{family} on {threads} threads") }
}
