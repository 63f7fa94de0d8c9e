//! `answers.csv`: every answer of a run, if the run was told to write its answers.

use predicament_predicates::Class;

crate::table! {
    /// `answers.csv`: one answer of one backend to one query.
    pub struct AnswerRow [Clone, PartialEq, Eq, Debug] in "answers.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// What was asked.
        pub task: String,
        /// The number of the query in its scene, from 0.
        pub query: u64 ["place"],
        /// The ids of its vertices, separated by blanks.
        pub args: String,
        /// The backend's name, with its parameters.
        pub backend: String,
        /// What it answered.
        pub answer: String,
        /// What is true without a perturbation or a band.
        pub exact: String,
        /// The class of the answer by itself, as in `summary.csv`.
        pub class: Class,
        /// The stage that settled it, asked alone; empty where the task has none.
        pub stage: String,
    }
}
