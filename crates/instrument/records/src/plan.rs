//! `plan.json`: the work of a run, written before the run does it.
//!
//! It is the first file in a run folder: only the plan shows the missing work of an interrupted run.

use predicament_predicates::UnknownName;
use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// The version of the run folder's format that this crate writes and reads.
pub const FORMAT: u32 = 2;

/// The amount of work of a run.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Level {
    /// The checks for every commit.
    Quick,
    /// All checks.
    Full,
}

impl std::fmt::Display for Level {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(match self {
            Level::Quick => "quick",
            Level::Full => "full",
        })
    }
}

impl std::str::FromStr for Level {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Level, UnknownName> {
        match name {
            "quick" => Ok(Level::Quick),
            "full" => Ok(Level::Full),
            _ => Err(UnknownName::new("level", name).listing("levels", ["quick", "full"])),
        }
    }
}

/// The `index`-th of `count` parts of a run, counted from 1; written `index/count`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Shard {
    index: u32,
    count: u32,
}

impl Shard {
    /// The whole run as one part.
    pub const WHOLE: Shard = Shard { index: 1, count: 1 };

    /// Part `index` of `count`; `None` unless 1 ≤ `index` ≤ `count`.
    #[must_use]
    pub const fn new(index: u32, count: u32) -> Option<Shard> {
        if 1 <= index && index <= count { Some(Shard { index, count }) } else { None }
    }

    /// The number of this part, from 1.
    #[must_use]
    pub const fn index(self) -> u32 {
        self.index
    }

    /// The number of parts.
    #[must_use]
    pub const fn count(self) -> u32 {
        self.count
    }
}

impl std::fmt::Display for Shard {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

/// An error: a text that is not a shard.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ParseShardError(String);

impl std::fmt::Display for ParseShardError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "`{}` is not a shard like 2/3: from 1 up to the number of shards", self.0)
    }
}

impl std::error::Error for ParseShardError {}

impl std::str::FromStr for Shard {
    type Err = ParseShardError;

    fn from_str(text: &str) -> Result<Shard, ParseShardError> {
        text.split_once('/')
            .and_then(|(index, count)| Shard::new(index.parse().ok()?, count.parse().ok()?))
            .ok_or_else(|| ParseShardError(text.to_owned()))
    }
}

impl TryFrom<String> for Shard {
    type Error = ParseShardError;

    fn try_from(text: String) -> Result<Shard, ParseShardError> {
        text.parse()
    }
}

impl From<Shard> for String {
    fn from(shard: Shard) -> String {
        shard.to_string()
    }
}

crate::table! {
    /// `scenes`: a scene that the plan runs on every backend.
    pub struct PlannedScene [Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug] in "scenes" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// The task.
        pub task: String,
        /// The family of inputs, by which timings and stage counts are grouped.
        pub family: String,
        /// The number of queries.
        pub queries: u64,
    }
}

impl PlannedScene {
    /// The first four cells of a scene's rows in every table: suite, scene, id and task.
    #[must_use]
    pub fn labels(&self) -> [String; 4] {
        [&self.suite, &self.scene, &self.scene_id, &self.task].map(String::clone)
    }
}

/// A suite that is left out of the run, and the reason.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
pub struct NotSelected {
    /// The suite's name.
    pub suite: String,
    /// The reason, in one line.
    pub reason: String,
}

/// The whole selection of scenes; a plan has one part of it.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Whole {
    /// The number of scenes in all parts together.
    pub scenes: u64,
    /// The SHA-256, in hex digits, of all these scenes; equal for all parts of one selection.
    pub digest: String,
    /// The places of this part's scenes among all scenes, from 0, in their order.
    pub places: Vec<u64>,
    /// The hash of the work plan that distributes the scenes; `None` if the scenes' ids distribute them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plan: Option<String>,
    /// The SHA-256 of the expectations that rows are compared with; `None` in folders of versions that did not record
    /// it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expected: Option<String>,
}

impl Whole {
    /// A selection of these scenes, and the part with the scenes in these places.
    #[must_use]
    pub fn new(scenes: &[PlannedScene], places: Vec<u64>) -> Whole {
        let mut digest = Sha256::new();
        for scene in scenes {
            for label in scene.labels().iter().chain([&scene.family, &scene.queries.to_string()]) {
                digest.update(label.as_bytes());
                digest.update([0]);
            }
        }
        let digest = digest.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
        Whole { scenes: scenes.len() as u64, digest, places, plan: None, expected: None }
    }
}

/// The work of a run.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Plan {
    /// The version of the run folder's format: [`FORMAT`].
    pub format: u32,
    /// The version of the tool that made the folder.
    pub created_by: String,
    /// The amount of work of the run.
    pub level: Level,
    /// The suites that were selected.
    pub suites: Vec<String>,
    /// The files of the suites that were named by path, by the suites' names.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub paths: BTreeMap<String, String>,
    /// The SHA-256 of each file in `paths`, in hex digits, by the suites' names.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub hashes: BTreeMap<String, String>,
    /// The engines by the backends' names. A folder is data: its readers never start an engine because it is listed
    /// here.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub engines: BTreeMap<String, EngineFile>,
    /// True if every answer is written to `answers.csv`.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub answers: bool,
    /// The number of evaluations that one backend spends on permuted arguments in one scene, if it was given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub permutations: Option<u64>,
    /// True if the scenes are timed: such a folder can't be resumed.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub timed: bool,
    /// The scenes of this shard, in the order in which they will be run.
    pub scenes: Vec<PlannedScene>,
    /// The backends' names, with their parameters.
    pub backends: Vec<String>,
    /// The tasks of each backend that runs for some tasks only; other backends run for all.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub only: BTreeMap<String, BTreeSet<String>>,
    /// The tasks whose answers are judged as a whole: if one law is broken, the whole answer to the scene is wrong.
    #[serde(default, skip_serializing_if = "BTreeSet::is_empty")]
    pub judged_whole: BTreeSet<String>,
    /// The rungs of the exact backend's ladder, cheapest first: report columns are in this order. Empty in folders of
    /// versions that did not record it.
    #[serde(default)]
    pub ladder: Vec<String>,
    /// The part of the selection that this plan has.
    pub shard: Shard,
    /// The whole selection that this is a part of; `None` in a whole run, and in folders of versions that did not
    /// record it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub whole: Option<Whole>,
    /// The suites that were left out on purpose.
    pub not_selected: Vec<NotSelected>,
    /// The tool's backends that run only if they are named, and were not named.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub left_out: Vec<String>,
    /// The number of findings that are kept of each class, for each scene and backend.
    pub findings_per_class: u64,
    /// The file of expectations that was named on the command line.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expected: Option<ExpectedFile>,
}

/// An engine as it was at the time of the run.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct EngineFile {
    /// The path of its `engine.toml`.
    pub file: String,
    /// The SHA-256 of its `engine.toml` in hex digits.
    pub sha256: String,
    /// The version of the library behind the engine; `None` if the engine gave none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub version: Option<String>,
}

/// A file of expectations that a run was given.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct ExpectedFile {
    /// The path of the file.
    pub file: String,
    /// The SHA-256 of the file in hex digits.
    pub sha256: String,
}

impl Plan {
    /// True if the backend runs for scenes of this task.
    #[must_use]
    pub fn takes(&self, backend: &str, task: &str) -> bool {
        self.only.get(backend).is_none_or(|tasks| tasks.contains(task))
    }

    /// The backends that run for scenes of this task, in their order.
    pub fn backends_for(&self, task: &str) -> impl Iterator<Item = &String> {
        self.backends.iter().filter(move |backend| self.takes(backend, task))
    }

    /// The command-line argument for a suite: its file if the run was given a file, otherwise its name.
    #[must_use]
    pub fn argument<'p>(&'p self, suite: &'p str) -> &'p str {
        self.paths.get(suite).map_or(suite, String::as_str)
    }

    /// The family of each scene, by suite, name, id and task: `summary.csv` does not have this column.
    #[must_use]
    pub fn families(&self) -> BTreeMap<[&str; 4], &str> {
        self.scenes.iter().map(|s| ([&*s.suite, &*s.scene, &*s.scene_id, &*s.task], &*s.family)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shards_are_one_based_and_written_as_on_the_command_line() {
        assert_eq!("2/3".parse::<Shard>().unwrap().to_string(), "2/3");
        assert_eq!(serde_json::to_string(&Shard::WHOLE).unwrap(), "\"1/1\"");
        for bad in ["0/3", "4/3", "1", "a/b", "1/0", ""] {
            assert!(bad.parse::<Shard>().is_err(), "{bad}");
        }
    }
}
