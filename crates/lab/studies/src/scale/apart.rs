//! A row that is measured in a process of its own.
//!
//! A process keeps memory that an answer has freed, and uses it again for the next answer. So the memory of an answer
//! can be measured once in a process, before any other answer. A process that the system kills costs one row.

use predicament_predicates::{Broken, Class};
use predicament_tasks::Contestant;

use super::{Row, Scale, measured};
use crate::compare::Input;
use crate::{Error, Host};

/// The row of a backend on a scene, from a new process. It is from this process if this is the new one, or the host has
/// no tool.
pub(super) fn row(study: &Scale, input: &Input, backend: &dyn Contestant, host: &dyn Host) -> Result<Row, Error> {
    let ended = if study.alone { None } else { host.again(&arguments(study, input, backend))? };
    match ended {
        None => measured::row(study, input, backend),
        Some(ended) => Ok(ended
            .and_then(|printed| read(&printed))
            .unwrap_or_else(|broken| Row::unanswered(input, backend).ended(broken.check, broken.message))),
    }
}

/// The arguments of the process for a row.
fn arguments(study: &Scale, input: &Input, backend: &dyn Contestant) -> Vec<String> {
    let (Scale { memory, common, .. }, n, task) = (study, input.of.n, input.task.name());
    let seed = common.seed;
    let words = format!("study scale --alone -t {task} --min {n} --max {n} --memory {memory} --seed {seed} -b");
    let mut words: Vec<String> = words.split(' ').map(str::to_owned).collect();
    words.push(backend.name());
    words.extend(common.threads.map(|threads| format!("--threads={threads}")));
    words
}

/// The row that a process has printed. A backend that ends its process as if all were well prints none.
fn read(printed: &str) -> Result<Row, Broken> {
    let lost = |message: String| Broken { class: Class::Panic, check: "crashed", message };
    match csv::Reader::from_reader(printed.as_bytes()).deserialize().next() {
        Some(row) => row.map_err(|error| lost(error.to_string())),
        None => Err(lost("ended without a row".to_owned())),
    }
}
