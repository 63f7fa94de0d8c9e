//! Parts shared by several commands: time limits, threads, and the note about suites that are not selected.

use std::time::Duration;

use predicament_corpus::LoadedScene;
use predicament_records::NotSelected;

use crate::exit::Failure;
use crate::host;
use crate::out::program;
use crate::select::NOT_NAMED;

/// Parses a time limit in seconds: a positive number up to some thirty years, because clocks can't add more.
pub fn seconds(text: &str) -> Result<Duration, String> {
    const MOST: f64 = 1e9;
    let seconds = text.parse().ok().filter(|&seconds: &f64| seconds > 0.0 && seconds <= MOST);
    let limit = seconds.and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
    limit.ok_or_else(|| format!("`{text}` is not a time limit; write seconds such as 30 or 0.5, at most {MOST}"))
}

/// The maximum number of threads, more than any machine has cores.
const MOST_THREADS: usize = 4096;

/// Sets the size of the thread pool. A process that calls the tool keeps the pool that it has.
pub fn set_threads(threads: Option<usize>) -> Result<(), Failure> {
    if let Some(threads) = threads.filter(|threads| !(1..=MOST_THREADS).contains(threads)) {
        return Err(Failure::usage(format!("--threads: {threads} threads; choose from 1 to {MOST_THREADS}")));
    }
    if threads.is_none() && host::is_called() {
        return Ok(());
    }
    let built = rayon::ThreadPoolBuilder::new().num_threads(threads.unwrap_or(0)).build_global();
    let has = rayon::current_num_threads();
    match built {
        Err(_) if host::is_called() && threads == Some(has) => Ok(()),
        Err(_) if host::is_called() => {
            Err(Failure::usage(format!("--threads: this process already has a pool of {has}; start a new process")))
        }
        built => built.map_err(|error| Failure::usage(format!("--threads: {error}"))),
    }
}

/// Prints the remarks about a scene as notes, one a line.
pub fn tell_remarks(loaded: &LoadedScene) {
    for remark in &loaded.remarks {
        note!("{}/{}: {remark}", loaded.suite, loaded.name);
    }
}

/// Prints a note about suites that were not selected because their data are missing.
pub fn tell_not_selected(suites: &[NotSelected], done: &str) {
    let unnamed = suites.iter().filter(|suite| suite.reason == NOT_NAMED).count();
    let unfetched: Vec<&str> =
        suites.iter().filter(|suite| suite.reason != NOT_NAMED).map(|suite| suite.suite.as_str()).collect();
    match (unnamed, unfetched.join(", ")) {
        (0, unfetched) if unfetched.is_empty() => {}
        (0, unfetched) => {
            note!("not {done}: {unfetched}: `{} corpus fetch` gets their data, then name them", program())
        }
        // If the command line names suites, there is no note.
        (_, _) => {}
    }
}
