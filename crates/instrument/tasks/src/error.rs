//! Reasons why a backend gives no answer, and why a query cannot be repeated.

use predicament_predicates::{Declined, Query, Vertex};

use crate::{Halt, Refusal};

/// The reason why a backend gives no answer to a scene, or is not timed on it.
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
    /// Two tasks have the same name, and the answer belongs to the other task.
    TwoTasks {
        /// The name of both tasks.
        task: &'static str,
    },
    /// The backend declines the scene, a predicate or a construction.
    Refused(Refusal),
    /// The watch stopped it.
    Stopped,
    /// The backend times its predicates with its own clock, and the task is timed as a whole.
    OwnClock,
    /// The operating system does not provide threads for timing: its reason.
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
                f.write_str("it times its predicates with its own clock, which does not cover the algorithm")
            }
            AnswerError::Threads(reason) => f.write_str(reason),
        }
    }
}

impl std::error::Error for AnswerError {}

/// The reason why a finding's query cannot be repeated.
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
    /// The query does not belong to the task: it lacks the objects of its questions.
    NotOfTask {
        /// The query.
        query: Query,
        /// The error, as the end of a sentence: `names no probe`.
        what: &'static str,
    },
    /// The scene lacks the object that the query's vertices name.
    NotInScene {
        /// The query.
        query: Query,
        /// The missing object, as a sentence: `the scene has no such segment`.
        what: &'static str,
    },
    /// The scene has no such predicate.
    Declined(Declined),
}

impl ExplainError {
    /// The error for a query that does not belong to the task.
    #[must_use]
    pub fn not_of_task(query: &Query, what: &'static str) -> ExplainError {
        ExplainError::NotOfTask { query: query.clone(), what }
    }

    /// The error for a query that names a missing object.
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
