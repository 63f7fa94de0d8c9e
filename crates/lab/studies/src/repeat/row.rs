//! The rows of the study's file.

use predicament_predicates::Class;
use serde::Serialize;

/// One scene asked again in one way.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct Row {
    /// The backend.
    pub backend: String,
    /// The task.
    pub task: String,
    /// The kind of the scene.
    pub scene: String,
    /// The way.
    pub way: String,
    /// `agree`, `unstable`, or the class of both failures.
    pub class: Class,
    /// The number of compared answers: queries, or one whole answer.
    pub answers: u64,
    /// The number of answers that differ.
    pub unstable: u64,
    /// The first query whose answers differ; empty for whole answers.
    pub query: String,
    /// Its answer at first: a sign, or a digest of the whole answer.
    pub first: String,
    /// Its answer when it was asked again.
    pub second: String,
}
