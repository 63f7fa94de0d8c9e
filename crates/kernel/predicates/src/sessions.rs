//! Sessions for scenes that an algorithm makes itself.

use crate::{Backend, Declined, Off, Predicates, Scene};

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
