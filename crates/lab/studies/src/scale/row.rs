//! The rows of the study's file.

use serde::Serialize;

/// One scene, answered by one backend.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct Row {
    /// The task.
    pub task: String,
    /// The generator of the scene.
    pub family: String,
    /// The backend.
    pub backend: String,
    /// The number of elements: vertices of the scene, segments, or triangles.
    pub size: usize,
    /// `answered`, `refused` (too much memory) or the class of the failure.
    pub outcome: String,
    /// Seconds for the session and the answer; NaN without an answer.
    pub seconds: f64,
    /// The peak of the memory for the session and the answer, in bytes above the scene; NaN if it is not known.
    pub bytes: f64,
    /// The bytes that the task states for the answer and its files; NaN if it states none.
    pub stated: f64,
}

impl Row {
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
