//! The rows of the tables that every run folder has.
//!
//! Each struct is one line of its file: its fields are the columns, in order.
//! Columns are a contract; other programs read them.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::{Class, PlannedScene, Status};

/// A line of one of the CSV files of a run folder.
///
/// Tasks add files of their own by implementing this: see [`Record::of`](crate::Record::of)
/// for writing and [`RunDir::rows`](crate::RunDir::rows) for reading.
pub trait Row: Serialize + DeserializeOwned {
    /// The file's name.
    const FILE: &'static str;
    /// Its columns.
    const COLUMNS: &'static [&'static str];

    /// Whether the values make sense, beyond having the right types.
    ///
    /// # Errors
    /// What is wrong, in one line.
    fn check(&self) -> Result<(), String> {
        Ok(())
    }
}

/// The largest count: no run gets there, and sums of counts stay far below 2^64.
pub(crate) const MOST: u64 = 1 << 48;
/// What is wrong with a larger one.
pub(crate) const NO_COUNT: &str = "no run counts so far; restore the file";

/// `summary.csv`: one scene on one backend.
///
/// The first eight counts are of answers to queries or registered contacts,
/// the last four of whole scenes: 0 or the number of checks that failed.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct SummaryRow {
    /// The suite's name.
    pub suite: String,
    /// The scene's name in its suite.
    pub scene: String,
    /// The scene's content id.
    pub scene_id: String,
    /// What was asked: `orient2d`, `polygon-locate`, …
    pub task: String,
    /// The backend's name, with its parameters.
    pub backend: String,
    /// How many queries were asked.
    pub queries: u64,
    /// Answers of [`Class::Agree`].
    pub agree: u64,
    /// Answers of [`Class::TieBroken`].
    pub tie_broken: u64,
    /// Answers of [`Class::InBand`].
    pub in_band: u64,
    /// Answers of [`Class::Overreach`].
    pub overreach: u64,
    /// Answers of [`Class::MissedZero`].
    pub missed_zero: u64,
    /// Answers of [`Class::SignFlip`].
    pub sign_flip: u64,
    /// Violated axioms, [`Class::Inconsistent`].
    pub inconsistent: u64,
    /// Answers of [`Class::Nan`].
    pub nan: u64,
    /// Failed checks, [`Class::Topology`].
    pub topology: u64,
    /// Panics, [`Class::Panic`].
    pub panic: u64,
    /// Timeouts, [`Class::Timeout`].
    pub timeout: u64,
    /// Refusals, [`Class::Declined`].
    pub declined: u64,
    /// What the gate says.
    pub status: Status,
}

impl SummaryRow {
    /// A row whose counts are all zero.
    #[must_use]
    pub fn new(scene: &PlannedScene, backend: &str, queries: u64, status: Status) -> SummaryRow {
        let [suite, scene, scene_id, task] = scene.labels();
        SummaryRow {
            suite,
            scene,
            scene_id,
            task,
            backend: backend.to_owned(),
            queries,
            agree: 0,
            tie_broken: 0,
            in_band: 0,
            overreach: 0,
            missed_zero: 0,
            sign_flip: 0,
            inconsistent: 0,
            nan: 0,
            topology: 0,
            panic: 0,
            timeout: 0,
            declined: 0,
            status,
        }
    }

    /// The count of a class.
    #[must_use]
    pub fn count(&self, class: Class) -> u64 {
        match class {
            Class::Agree => self.agree,
            Class::TieBroken => self.tie_broken,
            Class::InBand => self.in_band,
            Class::Overreach => self.overreach,
            Class::MissedZero => self.missed_zero,
            Class::SignFlip => self.sign_flip,
            Class::Inconsistent => self.inconsistent,
            Class::Nan => self.nan,
            Class::Topology => self.topology,
            Class::Panic => self.panic,
            Class::Timeout => self.timeout,
            Class::Declined => self.declined,
        }
    }

    /// The count of a class, to be changed.
    pub fn count_mut(&mut self, class: Class) -> &mut u64 {
        match class {
            Class::Agree => &mut self.agree,
            Class::TieBroken => &mut self.tie_broken,
            Class::InBand => &mut self.in_band,
            Class::Overreach => &mut self.overreach,
            Class::MissedZero => &mut self.missed_zero,
            Class::SignFlip => &mut self.sign_flip,
            Class::Inconsistent => &mut self.inconsistent,
            Class::Nan => &mut self.nan,
            Class::Topology => &mut self.topology,
            Class::Panic => &mut self.panic,
            Class::Timeout => &mut self.timeout,
            Class::Declined => &mut self.declined,
        }
    }

    /// How many answers are wrong: the sum over [`Class::is_wrong_answer`].
    #[must_use]
    pub fn wrong(&self) -> u64 {
        Class::ALL.into_iter().filter(|class| class.is_wrong_answer()).map(|class| self.count(class)).sum()
    }

    /// Whether any query was answered.
    #[must_use]
    pub fn has_answers(&self) -> bool {
        Class::ALL.into_iter().any(|class| class.is_answer() && self.count(class) > 0)
    }
}

impl Row for SummaryRow {
    const FILE: &'static str = "summary.csv";
    const COLUMNS: &'static [&'static str] = &[
        "suite",
        "scene",
        "scene_id",
        "task",
        "backend",
        "queries",
        "agree",
        "tie_broken",
        "in_band",
        "overreach",
        "missed_zero",
        "sign_flip",
        "inconsistent",
        "nan",
        "topology",
        "panic",
        "timeout",
        "declined",
        "status",
    ];

    fn check(&self) -> Result<(), String> {
        let counts = Class::ALL.into_iter().map(|class| self.count(class)).chain([self.queries]);
        counts.max().filter(|&most| most > MOST).map_or(Ok(()), |most| Err(format!("a count of {most}: {NO_COUNT}")))
    }
}

/// `findings.csv`: one answer worth looking at.
///
/// At most [`Plan::findings_per_class`](crate::Plan::findings_per_class) rows
/// of each class are kept for each scene and backend; `summary.csv` counts all.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct FindingRow {
    /// What `replay`, `shrink` and `show` take.
    pub finding_id: String,
    /// The suite's name.
    pub suite: String,
    /// The scene's name in its suite.
    pub scene: String,
    /// The scene's content id.
    pub scene_id: String,
    /// What was asked.
    pub task: String,
    /// The backend's name, with its parameters.
    pub backend: String,
    /// What kind of finding.
    pub class: Class,
    /// The check that failed: `sign`, `antisymmetry`, `euler`, …
    pub check: String,
    /// Which query, as the oracle writes it; empty for findings about whole scenes.
    pub query: String,
    /// What the backend answered.
    pub got: String,
    /// What is true.
    pub truth: String,
    /// log2 of |determinant| / permanent, the degeneracy of the query; −inf
    /// for an exact zero, none where there is no determinant.
    pub log2_relative_det: Option<f64>,
    /// The exact distance from degeneracy in units of L, the scene's largest extent.
    #[serde(rename = "distance_over_L")]
    pub distance_over_l: Option<f64>,
    /// The rung of the ladder that settled the query; empty where unknown.
    pub stage: String,
}

impl Row for FindingRow {
    const FILE: &'static str = "findings.csv";
    const COLUMNS: &'static [&'static str] = &[
        "finding_id",
        "suite",
        "scene",
        "scene_id",
        "task",
        "backend",
        "class",
        "check",
        "query",
        "got",
        "truth",
        "log2_relative_det",
        "distance_over_L",
        "stage",
    ];

    fn check(&self) -> Result<(), String> {
        if self.log2_relative_det.is_some_and(f64::is_nan) {
            return Err("log2_relative_det is NaN".to_owned());
        }
        if self.distance_over_l.is_some_and(|d| d.is_nan() || d < 0.0) {
            return Err("distance_over_L is not a distance".to_owned());
        }
        Ok(())
    }
}

/// `throughput.csv`: one timed sample.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct ThroughputRow {
    /// What was asked.
    pub task: String,
    /// The family of inputs: `uniform`, `grid`, `near`, …
    pub family: String,
    /// The backend's name, with its parameters.
    pub backend: String,
    /// The version of the engine behind the backend.
    pub engine_version: String,
    /// How many queries the sample timed.
    pub queries: u64,
    /// The number of the sample, from 0.
    pub sample: u64,
    /// Nanoseconds of wall clock for one query.
    pub ns_per_query: f64,
}

impl Row for ThroughputRow {
    const FILE: &'static str = "throughput.csv";
    const COLUMNS: &'static [&'static str] =
        &["task", "family", "backend", "engine_version", "queries", "sample", "ns_per_query"];

    fn check(&self) -> Result<(), String> {
        if self.ns_per_query.is_finite() && self.ns_per_query > 0.0 {
            Ok(())
        } else {
            Err(format!("ns_per_query is {}, which is not a time", self.ns_per_query))
        }
    }
}

/// `stages.csv`: how many queries a rung of the ladder settled.
///
/// Rows with the same first four columns add up.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct StageRow {
    /// What was asked.
    pub task: String,
    /// The family of inputs.
    pub family: String,
    /// The backend's name, with its parameters.
    pub backend: String,
    /// The name of the rung; cheaper rungs come first in the file.
    pub stage: String,
    /// How many queries it settled.
    pub settled: u64,
}

impl Row for StageRow {
    const FILE: &'static str = "stages.csv";
    const COLUMNS: &'static [&'static str] = &["task", "family", "backend", "stage", "settled"];

    fn check(&self) -> Result<(), String> {
        let settled = self.settled;
        if settled > MOST { Err(format!("a count of {settled}: {NO_COUNT}")) } else { Ok(()) }
    }
}

/// `precision.csv`: what the coordinates of a scene span, and the arithmetic
/// that exact predicates got for it. It depends on the scene alone, not on a backend.
///
/// The last four columns name an arithmetic, or are empty where the scene has no
/// such predicate.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct PrecisionRow {
    /// The suite's name.
    pub suite: String,
    /// The scene's name in its suite.
    pub scene: String,
    /// The scene's content id.
    pub scene_id: String,
    /// Every coordinate is a multiple of two to this.
    pub lowest: i32,
    /// The bits of the largest difference of two coordinates of an axis, in units of 2^`lowest`.
    pub bits: i32,
    /// The arithmetic of `orient2d`.
    pub orient2d: String,
    /// The arithmetic of `orient3d`.
    pub orient3d: String,
    /// The arithmetic of `incircle`.
    pub incircle: String,
    /// The arithmetic of `insphere`.
    pub insphere: String,
}

impl Row for PrecisionRow {
    const FILE: &'static str = "precision.csv";
    const COLUMNS: &'static [&'static str] =
        &["suite", "scene", "scene_id", "lowest", "bits", "orient2d", "orient3d", "incircle", "insphere"];

    fn check(&self) -> Result<(), String> {
        if self.bits < 0 { Err(format!("bits is {}, which is not a number of bits", self.bits)) } else { Ok(()) }
    }
}
