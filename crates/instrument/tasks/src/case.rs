//! A loaded scene with the truth about it, shared by all backends.

use predicament_corpus::LoadedScene;
use predicament_predicates::{Contract, PredicateKind, Predicates, Scene};

use crate::once::Verdicts;
use crate::{Budget, Contestant, Task, Watch};

/// A scene with the truth about it.
pub struct Case<'a, T: Task> {
    /// The scene and its suite's information about it.
    pub loaded: &'a LoadedScene,
    /// The questions that the scene asks.
    pub content: &'a T::Content,
    /// The truth.
    pub truth: T::Truth,
    pub(crate) verdicts: Verdicts,
}

impl<'a, T: Task> Case<'a, T> {
    pub(crate) fn new(loaded: &'a LoadedScene, content: &'a T::Content, truth: T::Truth) -> Case<'a, T> {
        Case { loaded, content, truth, verdicts: Verdicts::default() }
    }

    /// The points.
    #[must_use]
    pub fn scene(&self) -> &'a Scene {
        &self.loaded.scene
    }
}

/// The judged backend, its session, and the thoroughness of judging.
#[derive(Clone, Copy)]
pub struct Asked<'a> {
    /// The backend.
    pub backend: &'a dyn Contestant,
    /// Its session, for additional queries of the judge.
    pub session: &'a dyn Predicates,
    /// The sample sizes.
    pub budget: Budget,
    /// The watch that can end the work.
    pub watch: &'a Watch<'a>,
}

impl Asked<'_> {
    /// The backend's contract for a predicate.
    #[must_use]
    pub fn contract(&self, kind: PredicateKind) -> Contract {
        self.backend.contract(kind)
    }
}

/// A reason why a scene is not judged, before any backend has answered: a person has to look first.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Dispute {
    /// The scene's author and the judge disagree: one of the two is wrong.
    Signs {
        /// The number of different answers.
        count: usize,
        /// The first of them, in words.
        first: String,
    },
    /// The scene is not one of its task, and is not marked as invalid input.
    Invalid {
        /// The reason, with the place.
        why: String,
        /// The fix, in one line.
        cure: String,
    },
    /// The scene is marked as invalid input, and the judge finds no flaw.
    Valid,
}

impl std::fmt::Display for Dispute {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Dispute::Signs { count, first } => write!(
                f,
                "{count} of the data's own signs differ from the exact ones, first {first}; correct the data first"
            ),
            Dispute::Invalid { why, cure } => write!(f, "{why}; {cure}"),
            Dispute::Valid => {
                f.write_str("the scene is marked `invalid`, and the judge finds no flaw; remove the mark")
            }
        }
    }
}
