//! Errors of an engine: in its configuration, its commands, its messages.

use std::path::PathBuf;
use std::process::ExitStatus;
use std::time::Duration;

use predicament_formats::{CorpusError, use_one_of};
use predicament_predicates::Broken;

use crate::command::printable;
use crate::config::{FILE, FOLDER, LONGEST_TEXT, MOST_BYTES as MOST_OF_FILE};
use crate::{MOST_ENTRIES, PREFIX};

/// The reason why an engine does not exist or cannot be used.
#[derive(Debug)]
#[non_exhaustive]
pub enum EngineError {
    /// The file of the engine cannot be read.
    Unread {
        /// The path of the file, as given.
        file: PathBuf,
        /// The error of the operating system.
        error: std::io::Error,
    },
    /// The file is not a regular file, or is longer than a configuration may be.
    NotAFile {
        /// The path of the file, as given.
        file: PathBuf,
    },
    /// The configuration is wrong.
    Config(CorpusError),
    /// The name of the engine differs from its folder's.
    OtherName {
        /// The file.
        file: PathBuf,
        /// The name in the file.
        called: String,
    },
    /// The folder of engines has no engine of this name.
    Unknown {
        /// The name.
        name: String,
        /// The folder.
        folder: PathBuf,
        /// The names of its engines.
        known: Vec<String>,
    },
    /// A command or a process of the engine failed.
    Failed {
        /// The engine's name.
        name: String,
        /// The engine's file.
        file: PathBuf,
        /// The failure, for example a crash, a silence that was too long, or a break of the protocol.
        why: EngineFailure,
    },
}

impl std::fmt::Display for EngineError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            EngineError::Unread { file, error } => {
                write!(f, "{}: {error}; name the engine.toml of an engine", file.display())
            }
            EngineError::NotAFile { file } => write!(
                f,
                "{}: it is not a regular file of at most {MOST_OF_FILE} bytes; name the engine.toml of an engine",
                file.display()
            ),
            EngineError::Config(error) => error.fmt(f),
            EngineError::OtherName { file, called } => {
                write!(f, "{}: the engine is called `{called}`; give it the name of its folder", file.display())
            }
            EngineError::Unknown { name, folder, known } => {
                write!(f, "no engine is called `{name}` in {}; ", folder.display())?;
                let known: Vec<&str> = known.iter().map(String::as_str).collect();
                match known.as_slice() {
                    [] => write!(f, "the folder has no engines; name an {FILE}, or set ${FOLDER}"),
                    known => write!(f, "{}, name its {FILE}, or set ${FOLDER}", use_one_of(name, known)),
                }
            }
            EngineError::Failed { name, file, why } => write!(f, "{PREFIX}{name} ({}): {why}", file.display()),
        }
    }
}

impl std::error::Error for EngineError {}

/// The failure of an engine's command or process.
#[derive(Debug)]
#[non_exhaustive]
pub enum EngineFailure {
    /// A setting in the backend's name is not valid; the message with the fix.
    Setting(String),
    /// The command is empty.
    NoProgram,
    /// A command did not start.
    NotStarted {
        /// The command.
        command: String,
        /// The error of the operating system.
        error: std::io::Error,
    },
    /// A command ended with a failure.
    Command {
        /// The command.
        command: String,
        /// The exit status of the command.
        status: ExitStatus,
        /// The last lines that the command printed.
        said: String,
    },
    /// The version command printed nothing.
    NoVersion {
        /// The command.
        command: String,
    },
    /// The version command printed nothing within this time.
    SilentVersion {
        /// The command.
        command: String,
        /// The silence limit.
        silence: Duration,
    },
    /// The process did not start, or does not speak the protocol.
    Process(Broken),
}

impl std::fmt::Display for EngineFailure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            EngineFailure::Setting(why) => f.write_str(why),
            EngineFailure::NoProgram => f.write_str("an empty command"),
            EngineFailure::NotStarted { command, error } => write!(f, "`{command}` did not start: {error}"),
            EngineFailure::Command { command, status, said } => write!(f, "`{command}` failed: {status}\n  {said}"),
            EngineFailure::NoVersion { command } => write!(f, "`{command}` printed no version"),
            EngineFailure::SilentVersion { command, silence } => {
                write!(f, "`{command}` printed no version within {silence:?}")
            }
            EngineFailure::Process(broken) => broken.fmt(f),
        }
    }
}

impl std::error::Error for EngineFailure {}

/// The way in which a message, or the order of messages, breaks the protocol.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum ProtocolError {
    /// The stream cannot be read, with the error of the operating system.
    Unread(String),
    /// The stream ends within a length, after this number of bytes.
    EndsInLength(usize),
    /// The stream ends within a message.
    EndsInBody {
        /// The number of bytes received.
        have: usize,
        /// The number of bytes of the message.
        size: u32,
    },
    /// The bytes are not the length of a message; usually they are text that was printed to stdout.
    NotALength([u8; 4]),
    /// An answer is longer than any correct answer.
    TooLong {
        /// The number of bytes of the answer.
        size: u32,
        /// The maximum number of bytes of a correct answer.
        most: u32,
    },
    /// The last entry of a message is incomplete.
    CutOff,
    /// A message has more than [`MOST_ENTRIES`] entries.
    TooManyEntries,
    /// A key is not an ASCII word.
    BadKey,
    /// A message does not begin with its `type`.
    NoType,
    /// A message to be sent has more bytes than the protocol allows.
    TooLongToSend {
        /// The number of bytes of the message.
        size: usize,
        /// The maximum number of bytes of a message.
        most: u32,
    },
    /// A key to be sent has more than 255 bytes.
    LongKey(String),
    /// A message lacks a key.
    Missing {
        /// The type of the message.
        message: String,
        /// The key.
        key: String,
    },
    /// The value of a key is not a number.
    NotANumber {
        /// The type of the message.
        message: String,
        /// The key.
        key: String,
        /// The value.
        text: String,
    },
    /// The engine declined the greeting, with this reason.
    GreetingDeclined(String),
    /// The engine answered the greeting by a message of this type.
    GreetedBy(String),
    /// The engine and the tool have different versions of the protocol.
    Version {
        /// The version of the engine.
        engine: String,
        /// The version of the tool.
        tool: &'static str,
    },
    /// The engine offers something that is not a predicate of the protocol.
    UnknownPredicate(String),
    /// The engine offers neither a predicate nor a task.
    NoPredicate,
    /// The meaning of zero is neither exact nor never.
    UnknownZero(String),
    /// The precision is neither f64 nor f32.
    UnknownPrecision(String),
    /// The value of this key is not one short line.
    NotALine(String),
    /// The engine answered a batch by a message of this type.
    BatchAnsweredBy(String),
    /// The engine answered a task by a message of this type.
    TaskAnsweredBy(String),
    /// A value has a number of bytes that is not a multiple of the size of its numbers.
    Ragged {
        /// The key.
        key: String,
        /// The number of bytes.
        bytes: usize,
    },
    /// The number of signs differs from the number of queries.
    Signs {
        /// The number of signs received.
        came: usize,
        /// The number of queries.
        queries: usize,
    },
    /// The answer to a query is a byte that is not a sign.
    NotASign {
        /// The query, in words.
        query: String,
        /// The byte.
        byte: u8,
    },
    /// The engine reports more time than the tool waited.
    Time {
        /// The nanoseconds that the engine reports.
        said: u64,
        /// The time that the answer took.
        took: Duration,
    },
    /// An answer has the number of another question.
    OtherQuestion {
        /// The number in the answer.
        of: String,
        /// The number of the question.
        id: u64,
    },
    /// An answer of this type lacks the number of its question.
    NoId(String),
    /// A message of this type arrived without a question.
    Unasked(String),
}

impl std::fmt::Display for ProtocolError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            ProtocolError::Unread(error) => f.write_str(error),
            ProtocolError::EndsInLength(have) => write!(f, "a message that ends after {have} bytes"),
            ProtocolError::EndsInBody { have, size } => {
                write!(f, "a message that ends after {have} of its {size} bytes")
            }
            ProtocolError::NotALength(bytes) => {
                let text = String::from_utf8_lossy(bytes);
                write!(
                    f,
                    "no message: it begins with the bytes `{}`; an engine prints to stderr, not to stdout",
                    text.escape_default()
                )
            }
            ProtocolError::TooLong { size, most } => {
                write!(f, "an answer of {size} bytes; at most {most} are allowed")
            }
            ProtocolError::CutOff => f.write_str("a message whose last entry is cut off"),
            ProtocolError::TooManyEntries => write!(f, "a message of more than {MOST_ENTRIES} entries"),
            ProtocolError::BadKey => f.write_str("a message with a key that is not an ASCII word"),
            ProtocolError::NoType => f.write_str("a message that does not begin with its `type`"),
            ProtocolError::TooLongToSend { size, most } => {
                write!(f, "a message of {size} bytes; the protocol allows {most}")
            }
            ProtocolError::LongKey(key) => write!(f, "the key `{key}` is too long"),
            ProtocolError::Missing { message, key } => write!(f, "a message `{message}` without `{key}`"),
            ProtocolError::NotANumber { message, key, text } => {
                write!(f, "`{key}` of `{message}` is `{text}`, which is not a number")
            }
            ProtocolError::GreetingDeclined(reason) => f.write_str(reason),
            ProtocolError::GreetedBy(kind) => write!(f, "`hello` was answered by `{kind}`"),
            ProtocolError::Version { engine, tool } => {
                write!(f, "it speaks protocol {engine}, and the tool {tool}; rebuild the engine")
            }
            ProtocolError::UnknownPredicate(name) => {
                write!(f, "it offers `{name}`, which is not a predicate of the protocol")
            }
            ProtocolError::NoPredicate => f.write_str("it offers neither a predicate nor a task"),
            ProtocolError::UnknownZero(zero) => write!(f, "its zero is `{zero}`; it has to be exact or never"),
            ProtocolError::UnknownPrecision(precision) => {
                write!(f, "its precision is `{precision}`; it has to be f64 or f32")
            }
            ProtocolError::NotALine(key) => {
                write!(f, "its {key} is empty, longer than {LONGEST_TEXT} characters, or not one line")
            }
            ProtocolError::BatchAnsweredBy(kind) => write!(f, "a batch was answered by `{}`", printable(kind)),
            ProtocolError::TaskAnsweredBy(kind) => write!(f, "a task was answered by `{}`", printable(kind)),
            ProtocolError::Ragged { key, bytes } => {
                write!(f, "`{key}` has {bytes} bytes, which are not whole numbers")
            }
            ProtocolError::Signs { came, queries } => write!(f, "{came} signs came back for {queries} queries"),
            ProtocolError::NotASign { query, byte } => write!(f, "{query} was answered by the byte {byte}"),
            ProtocolError::Time { said, took } => {
                write!(f, "`ns` is {said}, and the answer took {} ns", took.as_nanos())
            }
            ProtocolError::OtherQuestion { of, id } => {
                write!(f, "an answer to question `{}`, where question {id} was asked", printable(of))
            }
            ProtocolError::NoId(kind) => write!(f, "an answer `{}` without the `id` of its question", printable(kind)),
            ProtocolError::Unasked(kind) => {
                write!(f, "it sent an extra message `{}`, without a question", printable(kind))
            }
        }
    }
}

impl std::error::Error for ProtocolError {}
