//! Sessions for scenes that an algorithm makes itself.

use predicament_predicates::{Declined, Predicates, Scene};

pub use predicament_predicates::Sessions;

/// Calls a function with a session of a scene; returns its result.
pub(crate) fn with<T, E: From<Declined>>(
    sessions: &dyn Sessions,
    scene: &Scene,
    ask: &mut dyn FnMut(&mut dyn Predicates) -> Result<T, E>,
) -> Result<T, E> {
    let mut answer = None;
    sessions.with_session(scene, &mut |session| answer = Some(ask(session)))?;
    answer.unwrap_or_else(|| Err(Declined::scene("the backend asked for no session").into()))
}
