//! Engines: predicates that another program answers, over its stdin and stdout.
//!
//! This crate reads an engine's configuration, starts its process, speaks the
//! protocol with it, and makes it a [`Backend`](predicament_predicates::Backend).
//! It never judges an answer and never ends the run: what an engine does wrong
//! is handed on as [`Broken`](predicament_predicates::Broken), and becomes a row of
//! the engine. `docs/ENGINES.md` describes the configuration and the protocol;
//! `engines/` has engines.
//!
//! * [`Config`]: `engine.toml`; [`find`]: from what follows `engine:` to one.
//! * [`Message`]: one message of the protocol, as bytes and back.
//! * [`EngineError`]: why there is no such engine; [`ProtocolError`]: how a message is not of the protocol.
//! * [`Engine`]: the backend; [`end_all`]: before an exit that drops nothing.

mod backend;
mod command;
mod config;
#[cfg(target_os = "linux")]
mod descendants;
mod error;
mod group;
mod mark;
mod message;
mod pipes;
mod pool;
mod process;
mod session;
mod started;

pub use backend::{Engine, PREFIX};
pub use command::{Step, chore};
pub use config::{Config, FILE, FOLDER, all, find, folder};
pub use error::{EngineError, EngineFailure, ProtocolError};
pub use group::end_all;
pub use message::{Bound, MOST_BYTES, MOST_ENTRIES, MOST_TEXT, Message};
