//! What several commands share: time limits, threads, and the line about suites that were not selected.

use std::time::Duration;

use predicament_records::NotSelected;

use crate::exit::Failure;
use crate::out::program;
use crate::select::NOT_NAMED;

/// A time limit from seconds: a positive number, up to some thirty years, as clocks can't add what is beyond them.
pub fn seconds(text: &str) -> Result<Duration, String> {
    const MOST: f64 = 1e9;
    let seconds = text.parse().ok().filter(|&seconds: &f64| seconds > 0.0 && seconds <= MOST);
    let limit = seconds.and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    limit.ok_or_else(|| format!("`{text}` is no time limit; write seconds such as 30 or 0.5, at most {MOST}"))
}

/// More threads than any machine has cores.
const MOST_THREADS: usize = 4096;

/// Sizes the thread pool.
pub fn set_threads(threads: Option<usize>) -> Result<(), Failure> {
    if let Some(threads) = threads.filter(|threads| !(1..=MOST_THREADS).contains(threads)) {
        return Err(Failure::usage(format!("--threads: {threads} threads; choose from 1 to {MOST_THREADS}")));
    }
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads.unwrap_or(0))
        .build_global()
        .map_err(|error| Failure::usage(format!("--threads: {error}")))
}

/// Says in one line which suites are not run (or the like): how many, where they were not asked for.
pub fn tell_not_selected(suites: &[NotSelected], done: &str) {
    let unnamed = suites.iter().filter(|suite| suite.reason == NOT_NAMED).count();
    let unfetched: Vec<&str> =
        suites.iter().filter(|suite| suite.reason != NOT_NAMED).map(|suite| suite.suite.as_str()).collect();
    match (unnamed, unfetched.join(", ")) {
        (0, unfetched) if unfetched.is_empty() => {}
        (0, unfetched) => {
            note!("not {done}: {unfetched}: `{} corpus fetch` gets their data, then name them", program())
        }
        // Whoever names suites means these.
        (_, _) => {}
    }
}
