//! `judged.csv`: which answers a run has judged, so that they can be timed later
//! without judging them again.

use predicament_records::PlannedScene;
use predicament_tasks::Outcome;

predicament_records::table! {
    /// `judged.csv`: the digest of the answers of one backend to one scene.
    pub struct JudgedRow [Clone, PartialEq, Eq, Debug] in "judged.csv" {
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
        /// The digest of the answers as users get them, 16 hex digits.
        pub digest: String,
    }
}

impl JudgedRow {
    /// The row of an outcome; none where there were no answers.
    pub fn of(scene: &PlannedScene, backend: &str, outcome: &Outcome) -> Vec<JudgedRow> {
        let row = |digest: u64| {
            let [suite, scene, scene_id, task] = scene.labels();
            JudgedRow { suite, scene, scene_id, task, backend: backend.to_owned(), digest: format!("{digest:016x}") }
        };
        outcome.digest.map(row).into_iter().collect()
    }
}
