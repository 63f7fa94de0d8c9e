//! The rows of the study's file, and groups of them.

use predicament_records::{Interface, Spread, geometric_mean};
use predicament_tasks::Kind;
use serde::{Deserialize, Serialize};

/// A variant on the scene of one input, beside the whole.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Row {
    /// The task.
    pub task: String,
    /// `general`, `near` or `degenerate`.
    pub kind: String,
    /// The generator of the scene.
    pub family: String,
    /// The timed interface: `single`, `batch` or `whole`.
    pub interface: String,
    /// The variant.
    pub backend: String,
    /// The backend with all devices, to which the variant is compared.
    pub whole: String,
    /// `equal` or `unequal` answers, `declined`, or `panic`.
    pub answers: String,
    /// Median nanoseconds of the whole per query or per unit that the scene counts.
    pub whole_ns: f64,
    /// The median of the variant's time over the whole's, sample by sample.
    pub ratio: f64,
    /// The lower quartile of these ratios.
    pub low: f64,
    /// The upper quartile of these ratios.
    pub high: f64,
    /// The number of samples.
    pub samples: usize,
}

/// The prefix of a device in the name of a variant.
const WITHOUT: &str = ":without=";

impl Row {
    /// The variant's column in tables: the device that it lacks, or the name of the backend.
    pub(super) fn column(&self) -> &str {
        self.backend.split_once(WITHOUT).map_or(&self.backend, |(_, device)| device)
    }
}

/// The backend with all devices, for a variant.
pub(super) fn whole_of(variant: &str) -> String {
    let backend = variant.split_once(WITHOUT).map_or("exact", |(backend, _)| backend);
    format!("{backend}{WITHOUT}nothing")
}

/// The rows of one kind of scenes and one interface.
pub(super) struct Group<'r> {
    /// The kind and the interface in words.
    pub name: String,
    rows: Vec<&'r Row>,
}

impl<'r> Group<'r> {
    /// All groups with rows, in the order of tables.
    pub fn all(rows: &'r [Row]) -> Vec<Group<'r>> {
        let interfaces =
            [(Interface::Single, "single queries"), (Interface::Batch, "batches"), (Interface::Whole, "algorithms")];
        let of = |(interface, words): (Interface, &str), kind: Kind| {
            let is = |row: &&Row| row.interface == interface.name() && row.kind == kind.name() && row.samples > 0;
            Group { name: format!("{words}, {}", kind.name()), rows: rows.iter().filter(is).collect() }
        };
        let all = interfaces.into_iter().flat_map(|by| Kind::ALL.map(|kind| of(by, kind)));
        all.filter(|group| !group.rows.is_empty()).collect()
    }

    /// The number of inputs.
    pub fn inputs(&self) -> usize {
        let mut inputs: Vec<[&str; 2]> = self.rows.iter().map(|row| [&*row.task, &*row.family]).collect();
        inputs.sort_unstable();
        inputs.dedup();
        inputs.len()
    }

    /// The geometric mean of a column's ratios, with the smallest and the largest; `None` if it was not timed.
    pub fn of(&self, column: &str) -> Option<(f64, [f64; 2])> {
        let ratios = || self.rows.iter().filter(|row| row.column() == column).map(|row| row.ratio);
        let Spread { min, max, .. } = Spread::of(ratios())?;
        Some((geometric_mean(ratios())?, [min, max]))
    }
}

/// The columns of tables, in the order of the rows.
pub(super) fn columns(rows: &[Row]) -> Vec<&str> {
    let mut columns: Vec<&str> = Vec::new();
    for row in rows {
        if !columns.contains(&row.column()) {
            columns.push(row.column());
        }
    }
    columns
}
