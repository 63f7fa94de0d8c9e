//! Why a backend gives no answer, and why a query cannot be asked again.

use predicament_predicates::{Declined, Query, Vertex};

use crate::{Halt, Refusal};

/// Why a backend gives no answer to a scene, or is not timed on it.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum AnswerError {
    /// The backend does not know the task.
    UnknownTask {
        /// The backend's name.
        backend: String,
        /// The task's name.
        task: String,
    },
    /// Two tasks have the same name, and the answer is one of the other task.
    TwoTasks {
        /// The name of both.
        task: &'static str,
    },
    /// The backend declines the scene, a predicate or a construction.
    Refused(Refusal),
    /// The watch stopped it.
    Stopped,
    /// The backend times its predicates by a clock of its own, and the task is timed as a whole.
    OwnClock,
    /// The operating system gives no threads to time it on: its reason.
    Threads(String),
}

impl From<Halt> for AnswerError {
    fn from(halt: Halt) -> AnswerError {
        match halt {
            Halt::Refused(refusal) => AnswerError::Refused(refusal),
            Halt::Stopped(_) => AnswerError::Stopped,
        }
    }
}

impl std::fmt::Display for AnswerError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            AnswerError::UnknownTask { backend, task } => write!(f, "{backend} knows no task `{task}`"),
            AnswerError::TwoTasks { task } => write!(f, "two tasks are called `{task}`"),
            AnswerError::Refused(refusal) => refusal.fmt(f),
            AnswerError::Stopped => f.write_str("stopped"),
            AnswerError::OwnClock => {
                f.write_str("it times its predicates by its own clock, which does not see the algorithm")
            }
            AnswerError::Threads(reason) => f.write_str(reason),
        }
    }
}

impl std::error::Error for AnswerError {}

/// Why the query of a finding cannot be asked again.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum ExplainError {
    /// The scene lacks a vertex of the query.
    NoVertex {
        /// The query.
        query: Query,
        /// The vertex.
        vertex: Vertex,
    },
    /// The query is not one of the task: it lacks what the task asks about.
    NotOfTask {
        /// The query.
        query: Query,
        /// What is wrong with it, as the end of a sentence: `names no probe`.
        what: &'static str,
    },
    /// The scene does not have what the query names by its vertices.
    NotInScene {
        /// The query.
        query: Query,
        /// What the scene does not have, as a sentence: `the scene has no such segment`.
        what: &'static str,
    },
    /// The scene has no such predicate.
    Declined(Declined),
}

impl ExplainError {
    /// The query is not one of the task.
    #[must_use]
    pub fn not_of_task(query: &Query, what: &'static str) -> ExplainError {
        ExplainError::NotOfTask { query: query.clone(), what }
    }

    /// The scene does not have what the query names.
    #[must_use]
    pub fn not_in_scene(query: &Query, what: &'static str) -> ExplainError {
        ExplainError::NotInScene { query: query.clone(), what }
    }
}

impl From<Declined> for ExplainError {
    fn from(declined: Declined) -> ExplainError {
        ExplainError::Declined(declined)
    }
}

impl std::fmt::Display for ExplainError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            ExplainError::NoVertex { query, vertex } => write!(f, "{query}: the scene has no vertex {vertex}"),
            ExplainError::NotOfTask { query, what } => write!(f, "`{query}` {what}"),
            ExplainError::NotInScene { query, what } => write!(f, "`{query}`: {what}"),
            ExplainError::Declined(declined) => declined.fmt(f),
        }
    }
}

impl std::error::Error for ExplainError {}
