//! `sampled.csv`: the answers whose truth covers only a part of their scene.

use crate::{PlannedScene, RowError};

crate::table! {
    /// `sampled.csv`: a scene and backend judged by the truth of only a part of the scene, because the whole takes too
    /// long.
    pub struct SampledRow [Clone, PartialEq, Eq, PartialOrd, Ord, Debug] in "sampled.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// The task.
        pub task: String,
        /// The backend's name, with its parameters.
        pub backend: String,
        /// The part of the scene with a known truth, in words.
        pub truth_of: String,
    }

    fn check(&self) -> Result<(), RowError> {
        if self.truth_of.is_empty() { Err(RowError::Empty { column: "truth_of" }) } else { Ok(()) }
    }
}

impl SampledRow {
    /// The row for a scene and backend.
    #[must_use]
    pub fn new(scene: &PlannedScene, backend: &str, truth_of: &str) -> SampledRow {
        let [suite, scene, scene_id, task] = scene.labels();
        SampledRow { suite, scene, scene_id, task, backend: backend.to_owned(), truth_of: truth_of.to_owned() }
    }
}
