//! A plan of work: what a run in parts will do, and which part does what, written down before any part begins.
//!
//! It is sealed by a hash. Each part that is run by it names the hash, so that parts of different plans can't be put together.

use std::path::Path;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::{Basis, Env, Error, Plan, PlannedScene, Shard, Whole};

/// The version of the file's format.
const FORMAT: u32 = 1;

/// What the tool was built from: parts of one plan have to agree in it.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Build {
    /// The tool's version.
    pub version: String,
    /// The commit that it was built from, where known.
    pub commit: Option<String>,
    /// Whether its sources differed from that commit, where known.
    pub dirty: Option<bool>,
}

impl Build {
    /// The build that has written this.
    #[must_use]
    pub fn of(env: &Env) -> Build {
        Build { version: env.package_version.clone(), commit: env.commit.clone(), dirty: env.dirty }
    }

    /// The same in words.
    #[must_use]
    pub fn describe(&self) -> String {
        let commit = self.commit.as_deref().map_or("an unknown commit", |commit| commit.get(..12).unwrap_or(commit));
        let changed = if self.dirty == Some(true) { " with changes" } else { "" };
        format!("{} of {commit}{changed}", self.version)
    }
}

/// The share of one scene in the work.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Share {
    /// The part that runs it, from 1.
    pub part: u32,
    /// What it will cost on all backends together, in microseconds of earlier runs; none where nothing is known.
    pub cost_us: Option<u64>,
    /// How that is known.
    pub basis: Basis,
}

/// The file that `plan` writes and that every part reads.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct WorkPlan {
    /// The version of this file's format.
    pub work_format: u32,
    /// The SHA-256, in hex digits, of the rest of the file.
    pub hash: String,
    /// The build that made it: only the same one runs it.
    pub build: Build,
    /// How many parts there are.
    pub parts: u32,
    /// The SHA-256 of the expectations that rows are held against.
    pub expected: String,
    /// The run folders whose costs were used.
    pub costs: Vec<String>,
    /// The share of each scene, in the order of the plan.
    pub shares: Vec<Share>,
    /// What one machine would do by itself: its `plan.json`.
    pub plan: Plan,
}

/// A part was asked for of another number of parts than the plan has.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct WrongParts {
    /// How many parts the plan has.
    pub planned: u32,
    /// Of how many parts one was asked for.
    pub asked: u32,
}

impl std::fmt::Display for WrongParts {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let WrongParts { planned, asked } = self;
        write!(f, "the plan has {planned} parts and not {asked}; write --shard k/{planned}")
    }
}

impl std::error::Error for WrongParts {}

impl WorkPlan {
    /// A plan with its hash.
    #[must_use]
    pub fn new(
        env: &Env,
        plan: Plan,
        parts: u32,
        shares: Vec<Share>,
        expected: String,
        costs: Vec<String>,
    ) -> WorkPlan {
        let hash = String::new();
        let build = Build::of(env);
        let work = WorkPlan { work_format: FORMAT, hash, build, parts, expected, costs, shares, plan };
        WorkPlan { hash: work.sealed(), ..work }
    }

    /// The hash that belongs to the rest.
    fn sealed(&self) -> String {
        let text = WorkPlan { hash: String::new(), ..self.clone() }.text();
        Sha256::digest(text).iter().map(|byte| format!("{byte:02x}")).collect()
    }

    /// The file.
    #[must_use]
    pub fn text(&self) -> String {
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }

    /// Reads the file, and refuses one in which a byte is not as it was written.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn read(path: &Path) -> Result<WorkPlan, Error> {
        let bytes = std::fs::read(path).map_err(Error::io(path))?;
        let work: WorkPlan = serde_json::from_slice(&bytes).map_err(|error| {
            let error = Error::json(path)(error);
            Error { message: format!("it is no plan of work: {}; `plan --out` writes one", error.message), ..error }
        })?;
        if work.work_format > FORMAT {
            let message = format!("it has format {}, and this tool reads formats up to {FORMAT}", work.work_format);
            return Err(Error::new(path, message));
        }
        let fits = work.shares.len() == work.plan.scenes.len()
            && work.shares.iter().all(|share| (1..=work.parts).contains(&share.part));
        if work.sealed() != work.hash || work.text().as_bytes() != bytes || !fits {
            return Err(Error::new(
                path,
                "it was changed since `plan` wrote it: its hash is another one; make it anew",
            ));
        }
        Ok(work)
    }

    /// What a part has to do; without one, what a single machine has to do.
    ///
    /// # Errors
    /// [`WrongParts`] if the plan has another number of parts.
    pub fn part(&self, shard: Option<Shard>) -> Result<Plan, WrongParts> {
        let Some(shard) = shard else { return Ok(self.plan.clone()) };
        if shard.count() != self.parts {
            return Err(WrongParts { planned: self.parts, asked: shard.count() });
        }
        if shard == Shard::WHOLE {
            return Ok(self.plan.clone());
        }
        let is_in = |place: &usize| self.shares[*place].part == shard.index();
        let places: Vec<usize> = (0..self.plan.scenes.len()).filter(is_in).collect();
        let scenes = places.iter().map(|&place| self.plan.scenes[place].clone()).collect();
        let places = places.into_iter().map(|place| place as u64).collect();
        let (plan, expected) = (Some(self.hash.clone()), Some(self.expected.clone()));
        let whole = Whole { plan, expected, ..Whole::new(&self.plan.scenes, places) };
        Ok(Plan { scenes, shard, whole: Some(whole), ..self.plan.clone() })
    }

    /// The scenes of a part with their shares.
    pub fn of_part(&self, part: u32) -> impl Iterator<Item = (&PlannedScene, &Share)> {
        self.plan.scenes.iter().zip(&self.shares).filter(move |(_, share)| share.part == part)
    }
}
