//! `state.json`: the outcome of a run, and the valid length of each table.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Component, Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::MAPS;
use super::regular::{header_length, read_regular};
use crate::Error;

/// The end of a run.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// All planned work was done.
    Complete,
    /// The run is still going, or was killed.
    Unfinished,
    /// The user interrupted the run.
    Interrupted,
    /// The run reached its time limit.
    Timeout,
}

impl Outcome {
    /// The outcome in a report's words.
    #[must_use]
    pub const fn describe(self) -> &'static str {
        match self {
            Outcome::Complete => "complete",
            Outcome::Unfinished => "incomplete: still running, or killed",
            Outcome::Interrupted => "incomplete: interrupted",
            Outcome::Timeout => "incomplete: out of time",
        }
    }

    /// The outcome's name in files.
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

/// The content of `state.json`. The file is replaced as a whole, never edited in place.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct State {
    /// The outcome of the run.
    pub outcome: Outcome,
    /// The length of each table in bytes when the last scene was done. Later bytes belong to an unfinished scene.
    pub committed: BTreeMap<String, u64>,
    /// The SHA-256, in hex digits, of the valid part of each table, of the plan, and of the pictures by
    /// `maps/NAME.png`. A run is resumed only if the digests match. Empty in folders of versions that did not record
    /// it.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub digests: BTreeMap<String, String>,
}

impl State {
    const FILE: &str = "state.json";

    /// The state of a run; if the folder has a plan and no state, the error says what to do.
    pub fn read(folder: &Path) -> Result<State, Error> {
        let path = folder.join(State::FILE);
        if State::is_missing(folder) {
            let message = if !folder.join(super::PLAN).exists() {
                "there is no such file: the folder is not a run folder".to_owned()
            } else if let Some(table) = State::lost(folder)? {
                format!("there is no such file, and {table} has rows; restore it from a copy, or start a new run")
            } else {
                "there is no such file: the run ended before its first result; `run --resume` starts it".to_owned()
            };
            return Err(Error::new(&path, message));
        }
        let state: State = super::sealed::read_json(&path)?;
        let is_told = |file: &&String| state.digests.contains_key(*file);
        match state.committed.keys().find(|file| !is_told(file)) {
            Some(file) if !state.digests.is_empty() => {
                let message = format!(
                    "`digests` lacks {file}, which `committed` has; restore the file from a copy, or start a new run"
                );
                Err(Error::new(&path, message))
            }
            _ => Ok(state),
        }
    }

    /// Refuses a name that is not the plan, one of the run's `tables` or a file in its folder: the run did not write
    /// it, and a resumed run would keep it.
    pub fn refuse_strangers<'a>(
        &self,
        folder: &Path,
        tables: impl Iterator<Item = &'a str> + Clone,
    ) -> Result<(), Error> {
        let is_there = |name: &str| {
            let path = Path::new(name);
            path.components().all(|part| matches!(part, Component::Normal(_))) && folder.join(path).is_file()
        };
        for (of, names) in
            [("committed", self.committed.keys().collect::<Vec<_>>()), ("digests", self.digests.keys().collect())]
        {
            for name in names {
                if name != super::PLAN && !tables.clone().any(|table| table == name) && !is_there(name) {
                    let message = format!(
                        "`{of}` lists {name:?}, but the run does not have this file; restore it from a copy, or \
                         start a new run"
                    );
                    return Err(Error::new(&folder.join(State::FILE), message));
                }
            }
        }
        Ok(())
    }

    /// The first table by name that has rows in a folder without a state, if any: the state was lost.
    pub fn lost(folder: &Path) -> Result<Option<String>, Error> {
        let mut with_rows = None;
        for path in tables(folder)? {
            let bytes = read_regular(&path)?;
            if header_length(&bytes) < bytes.len() as u64 {
                let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
                with_rows = with_rows.into_iter().chain([name]).min();
            }
        }
        Ok(with_rows)
    }

    /// True if a folder has no state: it is not a run, or the run ended while its folder was made.
    pub fn is_missing(folder: &Path) -> bool {
        !folder.join(State::FILE).exists()
    }

    pub fn write(&self, folder: &Path) -> Result<(), Error> {
        super::sealed::write_json(&folder.join(State::FILE), self)
    }
}

/// The files of a folder whose names are those of tables.
pub(super) fn tables(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let entries = fs::read_dir(folder).map_err(Error::io(folder))?;
    let paths = entries.map(|entry| Ok(entry.map_err(Error::io(folder))?.path())).collect::<Result<Vec<_>, Error>>()?;
    Ok(paths.into_iter().filter(|path| path.extension() == Some("csv".as_ref())).collect())
}

/// The key of a picture among the digests of a state.
pub(super) fn map_key(file: &str) -> String {
    format!("{MAPS}/{file}")
}
