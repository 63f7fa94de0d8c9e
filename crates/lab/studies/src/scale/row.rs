//! The rows of the study's file.

use predicament_tasks::Contestant;
use serde::{Deserialize, Serialize};

use crate::compare::Input;

/// One scene, answered by one backend.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Row {
    /// The task.
    pub task: String,
    /// The generator of the scene.
    pub family: String,
    /// The backend.
    pub backend: String,
    /// The number of elements: vertices of the scene, segments, or triangles. It is the `n` of the generator if the
    /// process died.
    pub size: usize,
    /// `answered`, `refused` (too much memory), the class of a failure, or the death of the process: `out of memory` or
    /// `crashed`.
    pub outcome: String,
    /// Seconds for the session and the answer; NaN without an answer.
    pub seconds: f64,
    /// The peak of the memory for the session and the answer, in bytes above the scene; NaN if it is not known.
    pub bytes: f64,
    /// The bytes that the task states for the answer and its files; NaN if it states none.
    pub stated: f64,
    /// The reason for a failure or a refusal; else empty.
    pub message: String,
}

impl Row {
    /// The row of a scene before it is answered.
    pub(super) fn unanswered(input: &Input, backend: &dyn Contestant) -> Row {
        Row {
            task: input.task.name().to_owned(),
            family: input.of.family.to_owned(),
            backend: backend.name(),
            size: input.of.n,
            outcome: String::new(),
            seconds: f64::NAN,
            bytes: f64::NAN,
            stated: f64::NAN,
            message: String::new(),
        }
    }

    /// The row with this outcome, and the reason for it.
    pub(super) fn ended(self, outcome: &str, message: String) -> Row {
        Row { outcome: outcome.to_owned(), message, ..self }
    }

    /// Nanoseconds for each element.
    pub(super) fn nanoseconds(&self) -> f64 {
        1e9 * self.seconds / self.count()
    }

    /// Measured and stated bytes for each element.
    pub(super) fn bytes_each(&self) -> [f64; 2] {
        [self.bytes, self.stated].map(|bytes| bytes / self.count())
    }

    pub(super) fn count(&self) -> f64 {
        predicament_records::approximately(self.size.max(1) as u64)
    }
}
