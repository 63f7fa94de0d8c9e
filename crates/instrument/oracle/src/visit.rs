//! Generic work on a backend: the backend is passed with its own type.

use predicament_judge::TieJudge;
use predicament_predicates::Backend;

#[cfg(shared_tasks)]
use crate::boxed::Boxed;

/// Work on one backend of any type.
pub trait Visit {
    /// The result of the work.
    type Out;

    /// Does the work; `ties` is the independent judge of the backend's tie-breaking, if it breaks ties.
    fn visit<B: Backend + 'static>(self, backend: B, ties: Option<Box<TieJudge>>) -> Self::Out;
}

/// Passes a backend to the visitor with its own type, or behind a pointer in untimed builds (`build.rs`).
pub(crate) fn hand<V: Visit, B: Backend + 'static>(visitor: V, backend: B, ties: Option<Box<TieJudge>>) -> V::Out {
    #[cfg(shared_tasks)]
    let backend = Boxed::new(backend);
    visitor.visit(backend, ties)
}
