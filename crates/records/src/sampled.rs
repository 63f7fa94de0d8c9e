//! `sampled.csv`: the answers that were held against the truth of a part of their scene.

use serde::{Deserialize, Serialize};

use crate::{PlannedScene, Row};

/// A scene and backend where the truth is about a part of the scene only, as all of it takes too long.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize, Deserialize)]
pub struct SampledRow {
    /// The suite's name.
    pub suite: String,
    /// The scene's name in its suite.
    pub scene: String,
    /// The scene's content id.
    pub scene_id: String,
    /// What was asked.
    pub task: String,
    /// The backend's name, with its parameters.
    pub backend: String,
    /// What the truth is about, in words.
    pub truth_of: String,
}

impl SampledRow {
    /// The row of a scene and backend.
    #[must_use]
    pub fn new(scene: &PlannedScene, backend: &str, truth_of: &str) -> SampledRow {
        let [suite, scene, scene_id, task] = scene.labels();
        SampledRow { suite, scene, scene_id, task, backend: backend.to_owned(), truth_of: truth_of.to_owned() }
    }
}

impl Row for SampledRow {
    const FILE: &'static str = "sampled.csv";
    const COLUMNS: &'static [&'static str] = &["suite", "scene", "scene_id", "task", "backend", "truth_of"];

    fn check(&self) -> Result<(), String> {
        if self.truth_of.is_empty() { Err("truth_of is empty".to_owned()) } else { Ok(()) }
    }
}
