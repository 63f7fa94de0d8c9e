//! One loaded scene with the truth about it, ready for one backend after another.

use predicament_corpus::LoadedScene;
use predicament_predicates::{Contract, PredicateKind, Predicates, Scene};

use crate::{Budget, Contestant, Task, Watch};

/// A scene with the truth about it.
pub struct Case<'a, T: Task> {
    /// The scene and what its suite says about it.
    pub loaded: &'a LoadedScene,
    /// What is asked.
    pub content: &'a T::Content,
    /// What is true.
    pub truth: T::Truth,
}

impl<'a, T: Task> Case<'a, T> {
    /// The points.
    #[must_use]
    pub fn scene(&self) -> &'a Scene {
        &self.loaded.scene
    }
}

/// The backend that is judged, its session, and how thoroughly it is judged.
#[derive(Clone, Copy)]
pub struct Asked<'a> {
    /// The backend.
    pub backend: &'a dyn Contestant,
    /// Its session, for the questions of a judge's own.
    pub session: &'a dyn Predicates,
    /// How much to sample.
    pub budget: Budget,
    /// Whether to go on.
    pub watch: &'a Watch<'a>,
}

impl Asked<'_> {
    /// What the backend promises about a predicate.
    #[must_use]
    pub fn contract(&self, kind: PredicateKind) -> Contract {
        self.backend.contract(kind)
    }
}

/// A scene whose author and the judge disagree: one of the two is wrong, and
/// nothing is compared until a person has looked.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Dispute {
    /// How many answers differ.
    pub count: usize,
    /// The first one, in words.
    pub first: String,
}

impl std::fmt::Display for Dispute {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} of the data's own signs differ from the exact ones, first {}", self.count, self.first)
    }
}
