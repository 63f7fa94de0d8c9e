//! Sessions for scenes that an algorithm makes itself.

use predicament_predicates::{Backend, Declined, Off, Predicates, Scene};

/// What prepares sessions: a backend, or what stands for one.
pub trait Sessions: Sync {
    /// Prepares a scene and hands the session over.
    ///
    /// # Errors
    /// [`Declined`]; then `ask` is not called.
    fn with_session(&self, scene: &Scene, ask: &mut dyn FnMut(&mut dyn Predicates)) -> Result<(), Declined>;
}

impl<B: Backend + Sync> Sessions for B {
    fn with_session(&self, scene: &Scene, ask: &mut dyn FnMut(&mut dyn Predicates)) -> Result<(), Declined> {
        ask(&mut self.prepare(scene, Off)?);
        Ok(())
    }
}

/// What a session of a scene answers.
pub(crate) fn with<T, E: From<Declined>>(
    sessions: &dyn Sessions,
    scene: &Scene,
    ask: &mut dyn FnMut(&mut dyn Predicates) -> Result<T, E>,
) -> Result<T, E> {
    let mut answer = None;
    sessions.with_session(scene, &mut |session| answer = Some(ask(session)))?;
    answer.unwrap_or_else(|| Err(Declined::scene("the backend asked for no session").into()))
}
