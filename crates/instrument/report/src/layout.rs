//! Shared parts of the sections about several runs: run columns and the order of backends.

use crate::table::Cell;
use crate::{RunDir, groups};

/// The number of a run; `None` if there is only one run.
#[must_use]
pub fn run_label(runs: &[RunDir], index: usize) -> Option<Cell> {
    (runs.len() > 1).then(|| Cell::from((index + 1).to_string()))
}

/// The head of the column that holds [`run_label`].
#[must_use]
pub fn run_head(runs: &[RunDir]) -> Option<&'static str> {
    (runs.len() > 1).then_some("run")
}

/// The backends of all runs: in the order of the plans, then the others by name.
#[must_use]
pub fn backends(runs: &[RunDir]) -> Vec<&str> {
    groups::backends(runs)
}

/// The index of a backend in the order of the plans.
#[must_use]
pub fn rank(order: &[&str], backend: &str) -> usize {
    order.iter().position(|b| *b == backend).unwrap_or(order.len())
}

/// The first few names, and the number of further ones.
pub(crate) fn some_of<'n>(names: impl ExactSizeIterator<Item = &'n str>, few: usize) -> String {
    let more = names.len().saturating_sub(few);
    let mut text = names.take(few).collect::<Vec<_>>().join(", ");
    if more > 0 {
        text += &format!(" and {more} more");
    }
    text
}
