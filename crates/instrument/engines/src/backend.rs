//! The backend: an engine as any other way to answer predicates.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

use predicament_predicates::{
    Backend, Batches, Broken, Class, Contract, Declined, PredicateKind, Scene, Tally, ZeroMeaning,
};

use crate::config::LONGEST_TEXT;
use crate::pool::Pool;
use crate::process::Process;
use crate::session::Session;
use crate::{Config, EngineError, EngineFailure, Message, ProtocolError, command, find};

/// What engines' names begin with.
pub const PREFIX: &str = "engine:";
/// The version of the protocol.
const PROTOCOL: &str = "1";

/// A program that answers predicates over stdin and stdout.
pub struct Engine {
    pub(crate) shared: Arc<Shared>,
    /// Whether it is asked for predicates that return at once.
    pub(crate) empty: bool,
}

/// What an engine says of itself.
pub(crate) struct Hello {
    pub predicates: Vec<PredicateKind>,
    zero: ZeroMeaning,
    pub single: bool,
    version: String,
}

/// What all sessions of an engine share.
pub(crate) struct Shared {
    config: Config,
    pub hello: Hello,
    pub processes: Pool,
    nanoseconds: AtomicU64,
}

impl Engine {
    /// The engine with this name in the folder of engines, or with this file.
    ///
    /// # Errors
    /// [`EngineError`]: there is no such engine, it does not start, or it does not speak the protocol.
    pub fn find(name: &str) -> Result<Engine, EngineError> {
        Engine::start(find(name)?)
    }

    /// Starts an engine and greets it.
    ///
    /// # Errors
    /// [`EngineError`] names the engine and its file: it does not start, or it does not speak the protocol.
    pub fn start(config: Config) -> Result<Engine, EngineError> {
        let named = |broken| config.error(EngineFailure::Process(broken));
        let mut process = Process::start(&config).map_err(named)?;
        let version = command::version(&config).map_err(|why| config.error(why))?;
        let hello = greet(&mut process, version).map_err(named)?;
        let shared = Shared { hello, processes: Pool::with(process), nanoseconds: AtomicU64::new(0), config };
        Ok(Engine { shared: Arc::new(shared), empty: false })
    }

    /// The name in its configuration.
    #[must_use]
    pub fn short_name(&self) -> &str {
        &self.shared.config.name
    }

    /// The predicates that it offers.
    #[must_use]
    pub fn predicates(&self) -> &[PredicateKind] {
        &self.shared.hello.predicates
    }
}

/// Says hello, and reads what the engine says of itself.
fn greet(process: &mut Process, version: Option<String>) -> Result<Hello, Broken> {
    let tool = concat!("predicament ", env!("CARGO_PKG_VERSION"));
    let hello = process.greet(Message::new("hello").with("protocol", PROTOCOL).with("tool", tool))?;
    read_hello(&hello, version).map_err(|error| process.broken(Class::Panic, "protocol", error.to_string()))
}

fn read_hello(hello: &Message, version: Option<String>) -> Result<Hello, ProtocolError> {
    match hello.kind().as_str() {
        "hello" => {}
        "declined" => return Err(ProtocolError::GreetingDeclined(hello.required("reason")?)),
        other => return Err(ProtocolError::GreetedBy(other.to_owned())),
    }
    let protocol = hello.required("protocol")?;
    if protocol != PROTOCOL {
        return Err(ProtocolError::Version { engine: protocol, tool: PROTOCOL });
    }
    let kind = |name: &str| {
        let found = PredicateKind::ALL.into_iter().find(|kind| kind.name() == name);
        found.ok_or_else(|| ProtocolError::UnknownPredicate(name.to_owned()))
    };
    line(hello, "name")?;
    let predicates = hello.required("predicates")?.split_whitespace().map(kind).collect::<Result<Vec<_>, _>>()?;
    if predicates.is_empty() {
        return Err(ProtocolError::NoPredicate);
    }
    let zero = match hello.required("zero")?.as_str() {
        "exact" => ZeroMeaning::Exact,
        "never" => ZeroMeaning::Never,
        other => return Err(ProtocolError::UnknownZero(other.to_owned())),
    };
    let single = match hello.required("precision")?.as_str() {
        "f64" => false,
        "f32" => true,
        other => return Err(ProtocolError::UnknownPrecision(other.to_owned())),
    };
    let version = match version {
        Some(version) => version,
        None => line(hello, "version")?,
    };
    Ok(Hello { predicates, zero, single, version })
}

/// A value that stands in tables: one short line.
fn line(hello: &Message, key: &str) -> Result<String, ProtocolError> {
    let text = hello.required(key)?;
    if text.trim().is_empty() || text.chars().any(char::is_control) || text.chars().nth(LONGEST_TEXT).is_some() {
        return Err(ProtocolError::NotALine(key.to_owned()));
    }
    Ok(text)
}

impl Shared {
    pub fn spent(&self, nanoseconds: u64) {
        self.nanoseconds.fetch_add(nanoseconds, Relaxed);
    }

    pub fn nanoseconds(&self) -> u64 {
        self.nanoseconds.load(Relaxed)
    }

    /// A new process, after one has broken or where all are busy with other scenes.
    pub fn start(&self) -> Result<Process, Broken> {
        let mut process = Process::start(&self.config)?;
        greet(&mut process, Some(self.hello.version.clone()))?;
        Ok(process)
    }
}

impl Backend for Engine {
    // One type of session for all tallies: algorithms are compiled once for engines.
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

    /// A batch is one message and one answer.
    fn batches(&self, _: PredicateKind) -> Batches {
        Batches::Own
    }

    fn version(&self) -> Option<String> {
        Some(self.shared.hello.version.clone())
    }

    /// The same engine, asked for predicates that return at once.
    fn binding(&self) -> Option<Engine> {
        (!self.empty).then(|| Engine { shared: Arc::clone(&self.shared), empty: true })
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Session<'s>, Declined> {
        Session::prepare(self, scene, tally)
    }
}
