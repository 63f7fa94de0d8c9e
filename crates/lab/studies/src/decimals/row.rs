//! The rows of the study's files, and sums of them.

use predicament_tasks::Agreement;
use serde::{Deserialize, Serialize};

/// The answers of a backend to queries of one kind.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Answered {
    /// The predicate.
    pub predicate: String,
    /// The figure that points are on or beside.
    pub figure: String,
    /// The source of the coordinates.
    pub place: String,
    /// The number of digits behind the point.
    pub digits: u32,
    /// The backend; the grid is that of the digits.
    pub backend: String,
    /// The number of answers; 0 if the backend declines.
    pub answers: u64,
    /// Answers that are right about the doubles.
    pub doubles: u64,
    /// Answers that are right about the decimals.
    pub written: u64,
    /// Ties of the decimals.
    pub ties: u64,
    /// Ties of the decimals that were answered by zero.
    pub ties_found: u64,
}

/// The time of a backend on queries of one kind.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Timed {
    /// The predicate.
    pub predicate: String,
    /// The source of the coordinates.
    pub place: String,
    /// The number of digits behind the point.
    pub digits: u32,
    /// The backend.
    pub backend: String,
    /// The median time of a query.
    pub ns_per_query: f64,
}

/// The name under which the grid of each number of digits is summed.
pub(super) const GRID: &str = "grid of the digits";

/// The prefix of backends with an epsilon.
pub(super) const EPSILON: &str = "epsilon:";

impl Answered {
    /// The name of the row's backend in tables.
    pub(super) fn column(&self) -> &str {
        if self.backend.starts_with("grid:") { GRID } else { &self.backend }
    }

    /// The counts of the row.
    fn agreement(&self) -> Agreement {
        let Answered { answers, doubles, written, ties, ties_found, .. } = *self;
        Agreement { answers, doubles, written, ties, ties_found }
    }
}

/// The sum of the counts of rows.
pub(super) fn sum<'r>(rows: impl IntoIterator<Item = &'r Answered>) -> Agreement {
    rows.into_iter().map(Answered::agreement).fold(Agreement::default(), |mut sum, row| {
        sum.answers += row.answers;
        sum.doubles += row.doubles;
        sum.written += row.written;
        sum.ties += row.ties;
        sum.ties_found += row.ties_found;
        sum
    })
}

/// The columns of tables, in the order of the rows: every backend but the epsilons, then the epsilon that is right most
/// often over the given rows.
pub(super) fn columns(rows: &[&Answered]) -> Vec<String> {
    let mut names: Vec<&str> = Vec::new();
    rows.iter().map(|row| row.column()).for_each(|name| {
        if !names.contains(&name) {
            names.push(name);
        }
    });
    let (epsilons, mut names): (Vec<&str>, Vec<&str>) = names.into_iter().partition(|name| name.starts_with(EPSILON));
    let right = |name: &&str| sum(rows.iter().copied().filter(|row| row.column() == *name)).written;
    // Of equal epsilons the first, which is the smallest.
    names.extend(epsilons.into_iter().rev().max_by_key(right));
    names.into_iter().map(str::to_owned).collect()
}
