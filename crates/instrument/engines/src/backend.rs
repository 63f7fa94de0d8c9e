//! The backend: an engine as a provider of predicates.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;
use std::time::{Duration, Instant};

use predicament_predicates::{Backend, Batches, Broken, Class, Contract, Declined, PredicateKind, Scene, Tally};

use crate::command::printable;
use crate::session::{CLOCKS, Session};
use crate::started::Shared;
use crate::{Bound, Config, EngineError, Message, ProtocolError, find};

/// The prefix of engines' names.
pub const PREFIX: &str = "engine:";

/// A program that answers predicates and tasks over stdin and stdout.
#[derive(Clone)]
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

    /// The tasks that the engine answers as a whole.
    #[must_use]
    pub fn tasks(&self) -> &[String] {
        &self.shared.hello.tasks
    }

    /// Asks a task by this message, of type `task`. Returns the answer, of type `answer`, with its nanoseconds.
    ///
    /// # Errors
    /// The inner error is the reason for declining the scene; [`Broken`] says how the engine failed.
    pub fn ask_task(&self, question: &Message) -> Result<Result<(Message, u64), Declined>, Broken> {
        let mut hasher = DefaultHasher::new();
        question.hash(&mut hasher);
        let bound = Bound::task(question.size());
        let shared = &self.shared;
        let answered = shared.processes.ask(
            (None, hasher.finish()),
            || shared.start(),
            |process| {
                let start = Instant::now();
                let answer = process.ask_within(question, bound)?;
                // An error of the library does not end the process: the next scene may be easier.
                if answer.kind() == "error" {
                    return Ok(Err(answer.text("message").unwrap_or_else(|| "an error without a message".to_owned())));
                }
                let read = answered(answer, start.elapsed());
                read.map(Ok).map_err(|error| process.broken(Class::Panic, "protocol", error.to_string()))
            },
        )?;
        shared.processes.works();
        match answered {
            Ok(Ok(answered)) => Ok(answered),
            Ok(Err(error)) => {
                Err(Broken { class: Class::Refused, check: "refused valid input", message: printable(&error) })
            }
            Err(declined) => Ok(Err(declined)),
        }
    }

    /// The predicates that the engine offers.
    #[must_use]
    pub fn predicates(&self) -> &[PredicateKind] {
        &self.shared.hello.predicates
    }
}

/// The answer to a task with its nanoseconds, or the reason for declining it.
fn answered(answer: Message, waited: Duration) -> Result<Result<(Message, u64), Declined>, ProtocolError> {
    match answer.kind().as_str() {
        "declined" => return Ok(Err(Declined::scene(printable(&answer.required("reason")?)))),
        "answer" => {}
        other => return Err(ProtocolError::TaskAnsweredBy(other.to_owned())),
    }
    let nanoseconds = answer.number("ns")?;
    if Duration::from_nanos(nanoseconds) > 2 * waited + CLOCKS {
        return Err(ProtocolError::Time { said: nanoseconds, took: waited });
    }
    Ok(Ok((answer, nanoseconds)))
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
        (!self.empty && !self.predicates().is_empty()).then(|| Engine { shared: Arc::clone(&self.shared), empty: true })
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Session<'s>, Declined> {
        Session::prepare(Arc::clone(&self.shared), self.empty, scene, tally)
    }
}
