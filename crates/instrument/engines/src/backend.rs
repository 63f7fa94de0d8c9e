//! The backend: an engine as a provider of predicates.

use std::sync::Arc;

use predicament_predicates::{Backend, Batches, Contract, Declined, PredicateKind, Scene, Tally};

use crate::session::Session;
use crate::started::Shared;
use crate::{Config, EngineError, find};

/// The prefix of engines' names.
pub const PREFIX: &str = "engine:";
/// A program that answers predicates over stdin and stdout.
pub struct Engine {
    shared: Arc<Shared>,
    /// True if the engine is asked for predicates that return at once.
    empty: bool,
}

impl Engine {
    /// The engine with this name in the folder of engines, or with this file.
    ///
    /// # Errors
    /// [`EngineError`] if the engine does not exist, does not start, or does not speak the protocol.
    pub fn find(name: &str) -> Result<Engine, EngineError> {
        Engine::start(find(name)?)
    }

    /// Starts an engine and exchanges greetings.
    ///
    /// # Errors
    /// [`EngineError`] with the engine and its file, if it does not start or does not speak the protocol.
    pub fn start(config: Config) -> Result<Engine, EngineError> {
        Ok(Engine { shared: Arc::new(Shared::greeted(config)?), empty: false })
    }

    /// The engine's name in its configuration.
    #[must_use]
    pub fn short_name(&self) -> &str {
        &self.shared.config.name
    }

    /// The predicates that the engine offers.
    #[must_use]
    pub fn predicates(&self) -> &[PredicateKind] {
        &self.shared.hello.predicates
    }
}

impl Backend for Engine {
    // One session type for all tallies: algorithms are compiled once for engines.
    type Session<'s, T: Tally + 's> = Session<'s>;

    fn name(&self) -> String {
        let name = &self.shared.config.name;
        if self.empty { format!("{PREFIX}{name}/empty") } else { format!("{PREFIX}{name}") }
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: self.shared.hello.zero, proved: false }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["engine"]
    }

    /// The kind of batches: each batch is one message and one answer.
    fn batches(&self, _: PredicateKind) -> Batches {
        Batches::Own
    }

    fn version(&self) -> Option<String> {
        Some(self.shared.hello.version.clone())
    }

    /// The engine, asked for predicates that return at once.
    fn binding(&self) -> Option<Engine> {
        (!self.empty).then(|| Engine { shared: Arc::clone(&self.shared), empty: true })
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Session<'s>, Declined> {
        Session::prepare(Arc::clone(&self.shared), self.empty, scene, tally)
    }
}
