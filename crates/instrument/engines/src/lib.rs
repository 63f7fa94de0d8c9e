//! Engines: predicates that another program answers, over its stdin and stdout.
//!
//! This crate reads an engine's configuration, starts its process, speaks the protocol with it, and makes it a
//! [`Backend`](predicament_predicates::Backend). It never judges an answer and never ends the run: an engine's failure
//! becomes a [`Broken`](predicament_predicates::Broken) value and a row of the engine. `docs/ENGINES.md` describes the
//! configuration and the protocol; `engines/` has engines.
//!
//! * [`Config`]: `engine.toml`; [`find`]: the configuration for the text after `engine:`.
//! * [`Parameter`]: what a library lets its users set, by `engine:NAME:key=value`.
//! * [`Message`]: one message of the protocol, and its encoding.
//! * [`EngineError`]: why an engine cannot be used; [`ProtocolError`]: how a message breaks the protocol.
//! * [`Engine`]: the backend; [`end_all`]: for an exit without drops.
//! * [`Group`]: a process that ends with its descendants.

mod backend;
mod command;
mod config;
#[cfg(target_os = "linux")]
mod descendants;
mod error;
mod group;
mod mark;
mod message;
mod parameter;
mod pipes;
mod pool;
mod process;
mod session;
mod started;

pub use backend::{Engine, PREFIX};
pub use command::{Step, chore};
pub use config::{Config, FILE, FOLDER, NAME_RULE, all, find, folder, is_name};
pub use error::{EngineError, EngineFailure, ProtocolError};
pub use group::{Group, end_all};
pub use message::{Bound, MOST_BYTES, MOST_ENTRIES, MOST_TEXT, Message};
pub use parameter::{Parameter, Range, split, swept};
