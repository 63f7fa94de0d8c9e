//! `state.json`: whether a run is complete, and the valid length of each table.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::Error;

/// How a run ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// It did all that was planned.
    Complete,
    /// It is still running, or was killed without a chance to say so.
    Unfinished,
    /// Somebody interrupted it.
    Interrupted,
    /// It ran out of time.
    Timeout,
}

impl Outcome {
    /// What a report says about it.
    #[must_use]
    pub const fn describe(self) -> &'static str {
        match self {
            Outcome::Complete => "complete",
            Outcome::Unfinished => "incomplete: still running, or killed",
            Outcome::Interrupted => "incomplete: interrupted",
            Outcome::Timeout => "incomplete: out of time",
        }
    }

    /// Its name in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Outcome::Complete => "complete",
            Outcome::Unfinished => "unfinished",
            Outcome::Interrupted => "interrupted",
            Outcome::Timeout => "timeout",
        }
    }
}

/// The SHA-256 of a table in hex digits.
pub(super) fn digest(bytes: &[u8]) -> String {
    hex(&Sha256::digest(bytes))
}

/// Bytes in hex digits.
pub(super) fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The file itself. It is replaced as a whole, never edited in place.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub(super) struct State {
    /// How the run ended.
    pub outcome: Outcome,
    /// The length of each table in bytes when the last scene was done: what
    /// comes after belongs to a scene that was not.
    pub committed: BTreeMap<String, u64>,
    /// The SHA-256 of each table of a complete run, in hex digits; none in folders made before it was written down.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub digests: BTreeMap<String, String>,
}

impl State {
    const FILE: &str = "state.json";

    pub fn read(folder: &Path) -> Result<State, Error> {
        super::reader::read_json(&folder.join(State::FILE))
    }

    pub fn write(&self, folder: &Path) -> Result<(), Error> {
        let path = folder.join(State::FILE);
        let next = folder.join("state.json.next");
        super::writer::write_json(&next, self)?;
        std::fs::rename(&next, &path).map_err(Error::io(&path))
    }
}
