//! `answers.csv`: every answer of a run that was asked for them.

use predicament_predicates::Class;
use serde::{Deserialize, Serialize};

use crate::Row;

/// One answer of one backend to one query.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct AnswerRow {
    /// The suite's name.
    pub suite: String,
    /// The scene's name in its suite.
    pub scene: String,
    /// The scene's content id.
    pub scene_id: String,
    /// What was asked.
    pub task: String,
    /// The number of the query in its scene, from 0.
    pub query: u64,
    /// The ids of its vertices, separated by blanks.
    pub args: String,
    /// The backend's name, with its parameters.
    pub backend: String,
    /// What it answered.
    pub answer: String,
    /// What is true without a perturbation or a band.
    pub exact: String,
    /// The class of the answer by itself.
    pub class: Class,
    /// The stage that settled it, asked alone; empty where the task has none.
    pub stage: String,
}

impl Row for AnswerRow {
    const FILE: &'static str = "answers.csv";
    const COLUMNS: &'static [&'static str] =
        &["suite", "scene", "scene_id", "task", "query", "args", "backend", "answer", "exact", "class", "stage"];
}
