//! `answers.csv`: every answer of a run, if the run was started with the option to write answers.

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
        /// The task.
        pub task: String,
        /// The number of the query in its scene, from 0.
        pub query: u64 ["place"],
        /// The ids of the query's vertices, separated by spaces.
        pub args: String,
        /// The backend's name, with its parameters.
        pub backend: String,
        /// The backend's answer.
        pub answer: String,
        /// The exact answer, without a perturbation or a band.
        pub exact: String,
        /// The class of this answer alone, as in `summary.csv`.
        pub class: Class,
        /// The stage that decides this query if it is asked alone; empty if the task has no stages.
        pub stage: String,
    }
}
