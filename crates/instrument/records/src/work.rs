//! A work plan: the work of a run in parts, and the part that does each scene, written before any part begins.
//!
//! A hash seals the plan. Each part that runs by the plan records the hash, so parts of different plans can't be
//! merged.

use std::path::Path;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::{Basis, Env, Error, Plan, PlannedScene, Shard, Whole};

/// The version of the file's format.
const FORMAT: u32 = 1;

/// The build of the tool: parts of one plan must have equal builds.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Build {
    /// The tool's version.
    pub version: String,
    /// The commit that the tool was built from, if known.
    pub commit: Option<String>,
    /// True if its sources differed from that commit; `None` if unknown.
    pub dirty: Option<bool>,
}

impl Build {
    /// The build that wrote this `Env`.
    #[must_use]
    pub fn of(env: &Env) -> Build {
        Build { version: env.package_version.clone(), commit: env.commit.clone(), dirty: env.dirty }
    }

    /// The build in words.
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
    /// The part that runs the scene, from 1.
    pub part: u32,
    /// The estimated cost on all backends together, in microseconds of earlier runs; `None` if unknown.
    pub cost_us: Option<u64>,
    /// The source of the estimate.
    pub basis: Basis,
}

/// A work plan: the file that `plan` writes and that every part reads.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct WorkPlan {
    /// The version of this file's format.
    pub work_format: u32,
    /// The SHA-256, in hex digits, of the rest of the file.
    pub hash: String,
    /// The build that made the plan: only the same build runs it.
    pub build: Build,
    /// The number of parts.
    pub parts: u32,
    /// The SHA-256 of the expectations that rows are compared with.
    pub expected: String,
    /// The run folders whose costs were used.
    pub costs: Vec<String>,
    /// The share of each scene, in the order of the plan.
    pub shares: Vec<Share>,
    /// The `plan.json` of the same run on a single machine.
    pub plan: Plan,
}

/// An error: the requested number of parts is not that of the plan.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct WrongParts {
    /// The number of parts of the plan.
    pub planned: u32,
    /// The requested number of parts.
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

    /// The hash of the rest of the file.
    fn sealed(&self) -> String {
        let text = WorkPlan { hash: String::new(), ..self.clone() }.text();
        Sha256::digest(text).iter().map(|byte| format!("{byte:02x}")).collect()
    }

    /// The text of the file.
    #[must_use]
    pub fn text(&self) -> String {
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }

    /// Reads the file, and refuses it if a byte has changed.
    ///
    /// # Errors
    /// If the file can't be read, has changed, or is not such a plan.
    pub fn read(path: &Path) -> Result<WorkPlan, Error> {
        let bytes = std::fs::read(path).map_err(Error::io(path))?;
        let work: WorkPlan = serde_json::from_slice(&bytes).map_err(|error| {
            let error = Error::json(path)(error);
            Error { message: format!("it is not a work plan: {}; `plan --out` writes one", error.message), ..error }
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
                "it was changed after `plan` wrote it: its hash does not match; make it again",
            ));
        }
        Ok(work)
    }

    /// The plan of a part, or of a single machine if `shard` is `None`.
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
