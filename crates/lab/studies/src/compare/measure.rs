//! What is measured: a number, and the interval that it is in.

use crate::folder::FolderError;
use predicament_records::{Spread, wilson};
use serde::{Deserialize, Serialize};

/// The word for a task in rows about sizes of features.
pub(super) const FEATURES: &str = "resolution";

/// A number about a backend on scenes of one kind: a row of `compare.csv`.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Measure {
    /// The task; `resolution` for sizes of features.
    pub task: String,
    /// `general`, `near` or `degenerate`; the feature's dimension for sizes of features; the knob in `stress.csv`.
    pub kind: String,
    /// What made the scenes; the feature for sizes of features; where the knob is in `stress.csv`.
    pub family: String,
    /// The backend's name, with its parameters.
    pub backend: String,
    /// What is measured.
    pub measure: String,
    /// What the number counts or is in.
    pub unit: String,
    /// The number.
    pub value: f64,
    /// The interval that it is in: 95 % for shares, the least and the largest for times, quartiles and ends for errors.
    pub low: f64,
    /// Its other end.
    pub high: f64,
    /// What it is of: scenes, queries, samples.
    pub of: u64,
}

/// Whose measures they are.
#[derive(Clone, Copy, Debug)]
pub(super) struct About<'a> {
    pub task: &'a str,
    pub kind: &'a str,
    pub family: &'a str,
    pub backend: &'a str,
}

impl About<'_> {
    pub fn measure(&self, measure: &str, unit: &str, value: f64, [low, high]: [f64; 2], of: u64) -> Measure {
        let [task, kind, family, backend] = [self.task, self.kind, self.family, self.backend].map(str::to_owned);
        let (measure, unit) = (measure.to_owned(), unit.to_owned());
        Measure { task, kind, family, backend, measure, unit, value, low, high, of }
    }

    /// A share of so many, times `per`.
    pub fn share(&self, measure: &str, unit: &str, per: f64, count: u64, of: u64) -> Measure {
        let share = if of == 0 {
            0.0
        } else {
            predicament_records::approximately(count) / predicament_records::approximately(of)
        };
        self.measure(measure, unit, per * share, wilson(count, of).map(|x| per * x), of)
    }

    /// The median of samples with their ends; none of none.
    pub fn median(&self, measure: &str, unit: &str, samples: &[f64]) -> Option<Measure> {
        let Spread { min, median, max, samples } = Spread::of(samples.iter().copied())?;
        Some(self.measure(measure, unit, median, [min, max], samples as u64))
    }
}

/// The rows of a file.
///
/// # Errors
/// [`FolderError`] with the file, and the line that is wrong.
pub(super) fn read(path: &std::path::Path) -> Result<Vec<Measure>, FolderError> {
    crate::folder::rows_of(path, "compare")
}
