//! A started and greeted engine: the state that all its sessions share.

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

use predicament_predicates::{Broken, Class, PredicateKind, ZeroMeaning};

use crate::config::LONGEST_TEXT;
use crate::pool::Pool;
use crate::process::Process;
use crate::{Config, EngineError, EngineFailure, Message, ProtocolError, command};

/// The version of the protocol.
const PROTOCOL: &str = "1";

/// The greeting of an engine: its predicates and tasks, and the meaning of its zero.
pub struct Hello {
    pub predicates: Vec<PredicateKind>,
    /// The names of the tasks that it answers as a whole.
    pub tasks: Vec<String>,
    pub zero: ZeroMeaning,
    pub single: bool,
    pub version: String,
}

/// The state that all sessions of an engine share: the configuration, the greeting and the processes.
pub struct Shared {
    pub config: Config,
    pub hello: Hello,
    pub processes: Pool,
    nanoseconds: AtomicU64,
}

/// Sends a greeting and reads the engine's description of itself.
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
    let kind = |name: &str| name.parse::<PredicateKind>().map_err(|_| ProtocolError::UnknownPredicate(name.to_owned()));
    line(hello, "name")?;
    let predicates = hello.required("predicates")?.split_whitespace().map(kind).collect::<Result<Vec<_>, _>>()?;
    let tasks = hello.text("tasks").unwrap_or_default();
    let tasks: Vec<String> = tasks.split_whitespace().map(str::to_owned).collect();
    if predicates.is_empty() && tasks.is_empty() {
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
    Ok(Hello { predicates, tasks, zero, single, version })
}

/// Reads a value for tables: one short line.
fn line(hello: &Message, key: &str) -> Result<String, ProtocolError> {
    let text = hello.required(key)?;
    if text.trim().is_empty() || text.chars().any(char::is_control) || text.chars().nth(LONGEST_TEXT).is_some() {
        return Err(ProtocolError::NotALine(key.to_owned()));
    }
    Ok(text)
}

impl Shared {
    /// Starts an engine and greets it.
    pub fn greeted(config: Config) -> Result<Shared, EngineError> {
        let named = |broken| config.error(EngineFailure::Process(broken));
        let mut process = Process::start(&config).map_err(named)?;
        let version = command::version(&config).map_err(|why| config.error(why))?;
        let hello = greet(&mut process, version).map_err(named)?;
        Ok(Shared { hello, processes: Pool::with(process), nanoseconds: AtomicU64::new(0), config })
    }

    pub fn spent(&self, nanoseconds: u64) {
        self.nanoseconds.fetch_add(nanoseconds, Relaxed);
    }

    pub fn nanoseconds(&self) -> u64 {
        self.nanoseconds.load(Relaxed)
    }

    /// Starts a new process, after a process has broken or while all are busy with other scenes.
    pub fn start(&self) -> Result<Process, Broken> {
        let mut process = Process::start(&self.config)?;
        greet(&mut process, Some(self.hello.version.clone()))?;
        Ok(process)
    }
}
