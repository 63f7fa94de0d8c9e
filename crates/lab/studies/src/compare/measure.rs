//! The measures of a comparison: a number, and its interval.

use crate::folder::FolderError;
use predicament_records::{Spread, wilson};
use serde::{Deserialize, Serialize};

/// The text in the task column for rows about sizes of features.
pub(super) const FEATURES: &str = "resolution";

/// A number about a backend on scenes of one kind: a row of `compare.csv`.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Measure {
    /// The task; `resolution` for sizes of features.
    pub task: String,
    /// `general`, `near` or `degenerate`; the feature's dimension for sizes of features; the knob in `stress.csv`.
    pub kind: String,
    /// The generator of the scenes; the feature for sizes of features; the knob's position in `stress.csv`.
    pub family: String,
    /// The backend's name, with its parameters.
    pub backend: String,
    /// The measured property.
    pub measure: String,
    /// The unit of the number.
    pub unit: String,
    /// The number.
    pub value: f64,
    /// The lower end of the number's interval.
    ///
    /// The interval is 95 % for shares, the least and the largest for times, quartiles and ends for errors.
    pub low: f64,
    /// The upper end of the interval.
    pub high: f64,
    /// The denominator: the number of scenes, queries or samples.
    pub of: u64,
}

/// The identifying columns of measures.
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

    /// A share of `of`, times `per`.
    pub fn share(&self, measure: &str, unit: &str, per: f64, count: u64, of: u64) -> Measure {
        let share = if of == 0 {
            0.0
        } else {
            predicament_records::approximately(count) / predicament_records::approximately(of)
        };
        self.measure(measure, unit, per * share, wilson(count, of).map(|x| per * x), of)
    }

    /// The median of samples with the least and the largest; `None` without samples.
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
