//! Sessions for scenes that an algorithm makes.

use crate::{Backend, Declined, Off, Predicates, Scene};

/// An interface that prepares sessions: a backend, or a replacement of one.
pub trait Sessions: Sync {
    /// Prepares a scene and calls `ask` with the session.
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
