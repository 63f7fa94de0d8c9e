//! A backend is handed over as some type, to whoever does work for any type.

use predicament_judge::TieJudge;
use predicament_predicates::Backend;

#[cfg(shared_tasks)]
use crate::boxed::Boxed;

/// Work for one backend, whatever its type.
pub trait Visit {
    /// The result of the work.
    type Out;

    /// Does the work; `ties` is the independent judge of how the backend breaks ties, if it does.
    fn visit<B: Backend + 'static>(self, backend: B, ties: Option<Box<TieJudge>>) -> Self::Out;
}

/// Hands a backend over as it is, or behind a pointer in builds that nobody times (`build.rs`).
pub(crate) fn hand<V: Visit, B: Backend + 'static>(visitor: V, backend: B, ties: Option<Box<TieJudge>>) -> V::Out {
    #[cfg(shared_tasks)]
    let backend = Boxed::new(backend);
    visitor.visit(backend, ties)
}
