//! Knobs that do not fit a task, or not to the end.

use predicament_tasks::{AnyTask, Knob, Turns};
use serde::{Deserialize, Serialize};

/// The end of a knob for a task before its last position: a row of `limits.csv`.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Limit {
    /// The task.
    pub task: String,
    /// The knob.
    pub knob: String,
    /// The largest position at which scenes are valid for the task; `None` if there is no such position.
    pub to: Option<i32>,
    /// The reason for the limit.
    pub why: String,
}

/// The limits of these tasks and knobs.
pub(super) fn limits(tasks: &[&'static dyn AnyTask], knobs: &[Knob]) -> Vec<Limit> {
    let of = |task: &&'static dyn AnyTask, knob: Knob| {
        let (to, why) = match task.turned_by(knob) {
            Turns::Everywhere => return None,
            Turns::UpTo(last, why) => (knob.positions().iter().copied().filter(|at| at.abs() <= last).max(), why),
            Turns::Nowhere(why) => (None, why),
        };
        Some(Limit { task: task.name().to_owned(), knob: knob.name().to_owned(), to, why: why.to_owned() })
    };
    tasks.iter().flat_map(|task| knobs.iter().filter_map(move |&knob| of(task, knob))).collect()
}
