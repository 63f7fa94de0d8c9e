//! The rows of the tables that every run folder has.
//!
//! Each struct is one line of its file: its fields are the columns, in order, and
//! their documentation is the published schema ([`table!`](crate::table)).
//! Columns are a contract; other programs read them.

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use predicament_predicates::PredicateKind;

use crate::{Class, Column, PlannedScene, RowError, Status};

/// A line of one of the CSV files of a run folder.
///
/// Tasks add their own files by implementing this trait, most easily by [`table!`](crate::table). See
/// [`Record::of`](crate::Record::of) for writing and [`RunDir::rows`](crate::RunDir::rows) for reading.
pub trait Row: Serialize + DeserializeOwned {
    /// The file's name.
    const FILE: &'static str;
    /// The names of the columns.
    const COLUMNS: &'static [&'static str];
    /// A description of a line.
    const ABOUT: &'static str = "";
    /// The columns with their types, units and meanings, in the same order. If it is empty, other programs get the
    /// columns as text.
    const SCHEMA: &'static [Column] = &[];

    /// The counts that files of earlier versions lack; they are read as 0.
    const LATER: &'static [&'static str] = &[];

    /// Checks the values beyond their types.
    ///
    /// # Errors
    /// If a value makes no sense; the error says why.
    fn check(&self) -> Result<(), RowError> {
        Ok(())
    }
}

/// The maximum count: no run reaches it, and sums of counts stay far below 2^64.
pub(crate) const MOST: u64 = 1 << 48;
/// The message about a larger count.
pub(crate) const NO_COUNT: &str = "the count is larger than any run can reach; restore the file";

crate::table! {
    /// `summary.csv`: one scene on one backend.
    ///
    /// The counts from `agree` to `nan`, and `unstable`, are numbers of answers to queries or of registered contacts.
    /// The others are about the whole scene: 0, or the number of failed checks.
    pub struct SummaryRow [Clone, PartialEq, Eq, Debug] in "summary.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// The task: `orient2d`, `polygon-locate`, …
        pub task: String,
        /// The backend's name, with its parameters.
        pub backend: String,
        /// The number of queries.
        pub queries: u64,
        /// Answers equal to the exact answer: class `agree`.
        pub agree: u64,
        /// Exact zeros answered by a sign, as the contract of tie-breaking backends allows: class `tie_broken`.
        pub tie_broken: u64,
        /// Zeros for values within the upper tolerance, as the contract of backends with a band allows: class
        /// `in_band`.
        pub in_band: u64,
        /// Zeros for values beyond the upper tolerance, or, without a band, for any value except zero: class
        /// `overreach`.
        pub overreach: u64,
        /// Signs for degeneracies that the backend's contract says it reports: class `missed_zero`.
        pub missed_zero: u64,
        /// Answers with the opposite sign: class `sign_flip`.
        pub sign_flip: u64,
        /// Violated axioms, where answers contradict each other: class `inconsistent`.
        pub inconsistent: u64,
        /// Answers for which the arithmetic produced a NaN: class `nan`.
        pub nan: u64,
        /// Failed checks of the whole scene: class `topology`.
        pub topology: u64,
        /// Checks of the whole scene that failed only because output coordinates are rounded: class `rounded`.
        pub rounded: u64,
        /// Panics of the backend: class `panic`.
        pub panic: u64,
        /// Timeouts: class `timeout`.
        pub timeout: u64,
        /// Scenes that the backend declined: class `declined`.
        pub declined: u64,
        /// Errors that a library reported for valid input: class `refused`.
        pub refused: u64,
        /// Answers to invalid input: class `accepted`.
        pub accepted: u64,
        /// Queries that got another answer when they were asked again: class `unstable`.
        pub unstable: u64,
        /// The verdict of the gate: `ok`, `expected`, `unexpected`, `unexpected_pass`.
        pub status: Status,
    }

    const LATER: &'static [&'static str] = &["unstable"];

    fn check(&self) -> Result<(), RowError> {
        let counts = Class::ALL.into_iter().map(|class| self.count(class)).chain([self.queries]);
        counts.max().map_or(Ok(()), RowError::check_count)
    }
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
            rounded: 0,
            panic: 0,
            timeout: 0,
            declined: 0,
            refused: 0,
            accepted: 0,
            unstable: 0,
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
            Class::Rounded => self.rounded,
            Class::Panic => self.panic,
            Class::Timeout => self.timeout,
            Class::Declined => self.declined,
            Class::Refused => self.refused,
            Class::Accepted => self.accepted,
            Class::Unstable => self.unstable,
        }
    }

    /// The count of a class, mutable.
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
            Class::Rounded => &mut self.rounded,
            Class::Panic => &mut self.panic,
            Class::Timeout => &mut self.timeout,
            Class::Declined => &mut self.declined,
            Class::Refused => &mut self.refused,
            Class::Accepted => &mut self.accepted,
            Class::Unstable => &mut self.unstable,
        }
    }

    /// The number of wrong answers: the sum over [`Class::is_wrong_answer`].
    #[must_use]
    pub fn wrong(&self) -> u64 {
        Class::ALL.into_iter().filter(|class| class.is_wrong_answer()).map(|class| self.count(class)).sum()
    }

    /// True if any query was answered.
    #[must_use]
    pub fn has_answers(&self) -> bool {
        Class::ALL.into_iter().any(|class| class.is_answer() && self.count(class) > 0)
    }
}

crate::table! {
    /// `findings.csv`: one finding.
    ///
    /// For each scene, backend and class, at most `findings_per_class` (see `plan.json`) rows are kept; `summary.csv`
    /// counts all findings.
    pub struct FindingRow [Clone, PartialEq, Debug] in "findings.csv" {
        /// The id of the finding, for `replay`, `shrink` and `show`.
        pub finding_id: String,
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// The task.
        pub task: String,
        /// The backend's name, with its parameters.
        pub backend: String,
        /// The class of the finding, which is a column of `summary.csv`.
        pub class: Class,
        /// The check that failed: `sign`, `antisymmetry`, `euler`, …
        pub check: String,
        /// The query, as the oracle writes it; empty for findings about whole scenes.
        pub query: String,
        /// The backend's answer.
        pub got: String,
        /// The true answer.
        pub truth: String,
        /// log2 of |determinant| / permanent, the degeneracy of the query; −inf for an exact zero, null if there is no
        /// determinant.
        pub log2_relative_det: Option<f64> ["powers of two"],
        /// The exact distance from degeneracy in units of L, the scene's largest extent.
        pub distance_over_l: Option<f64> as "distance_over_L" ["L"],
        /// The rung of the ladder that decided the query; empty if unknown.
        pub stage: String,
    }

    fn check(&self) -> Result<(), RowError> {
        let wrong = |column, value, wanted| Err(RowError::Number { column, value, wanted });
        match (self.log2_relative_det, self.distance_over_l) {
            (Some(log2), _) if log2.is_nan() => wrong("log2_relative_det", log2, "a logarithm"),
            (_, Some(d)) if d.is_nan() || d < 0.0 => wrong("distance_over_L", d, "a distance"),
            _ => Ok(()),
        }
    }
}

/// True if the task asks only for the signs of one predicate.
#[must_use]
pub fn is_predicate(task: &str) -> bool {
    task.parse::<PredicateKind>().is_ok()
}

/// The interface by which a backend was timed. Times of different interfaces are never compared.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Interface {
    /// Single queries, one per call.
    Single,
    /// Slices of queries, answered by the backend's own code for slices.
    Batch,
    /// Slices of queries, answered by a loop over single queries.
    Loop,
    /// Whole scenes.
    Whole,
}

impl Interface {
    /// All four interfaces.
    pub const ALL: [Interface; 4] = [Interface::Single, Interface::Batch, Interface::Loop, Interface::Whole];

    /// The interface's name in every file.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Interface::Single => "single",
            Interface::Batch => "batch",
            Interface::Loop => "loop",
            Interface::Whole => "whole",
        }
    }
}

impl std::fmt::Display for Interface {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(self.name())
    }
}

crate::table! {
    /// `throughput.csv`: one timed sample.
    pub struct ThroughputRow [Clone, PartialEq, Debug] in "throughput.csv" {
        /// The task.
        pub task: String,
        /// The family of inputs: `uniform`, `grid`, `near`, …
        pub family: String,
        /// The backend's name, with its parameters.
        pub backend: String,
        /// The interface that was timed: one query at a time, batches, or the answer to a whole scene.
        pub interface: Interface,
        /// The version of the engine behind the backend.
        pub engine_version: String,
        /// The number of queries timed in the sample.
        pub queries: u64,
        /// The number of the sample, from 0.
        pub sample: u64 ["place"],
        /// Nanoseconds of wall time per query.
        pub ns_per_query: f64 ["ns"],
    }

    fn check(&self) -> Result<(), RowError> {
        RowError::check_time("ns_per_query", self.ns_per_query)
    }
}

crate::table! {
    /// `stages.csv`: the number of queries that a rung of the ladder decided.
    ///
    /// The counts of rows with the same first four columns are to be added.
    pub struct StageRow [Clone, PartialEq, Eq, Debug] in "stages.csv" {
        /// The task.
        pub task: String,
        /// The family of inputs.
        pub family: String,
        /// The backend's name, with its parameters.
        pub backend: String,
        /// The name of the rung; cheaper rungs come first in the file.
        pub stage: String,
        /// The number of queries that this rung decided.
        pub settled: u64,
    }

    fn check(&self) -> Result<(), RowError> {
        RowError::check_count(self.settled)
    }
}

crate::table! {
    /// `precision.csv`: the range of a scene's coordinates, and the arithmetic chosen for each exact predicate. It
    /// depends only on the scene, not on a backend.
    ///
    /// The last four columns name an arithmetic; a column is empty if the scene has no such predicate.
    pub struct PrecisionRow [Clone, PartialEq, Eq, Debug] in "precision.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// An exponent e such that every coordinate is a multiple of 2^e.
        pub lowest: i32 ["power of two"],
        /// The number of bits of the largest coordinate difference along an axis, in units of 2^`lowest`.
        pub bits: i32 ["bits"],
        /// The arithmetic of `orient2d`.
        pub orient2d: String,
        /// The arithmetic of `orient3d`.
        pub orient3d: String,
        /// The arithmetic of `incircle`.
        pub incircle: String,
        /// The arithmetic of `insphere`.
        pub insphere: String,
    }

    fn check(&self) -> Result<(), RowError> {
        let (column, value, wanted) = ("bits", f64::from(self.bits), "a number of bits");
        if self.bits < 0 { Err(RowError::Number { column, value, wanted }) } else { Ok(()) }
    }
}

impl PrecisionRow {
    /// The names of the predicates that [`choices`](PrecisionRow::choices) are about.
    #[must_use]
    pub fn predicates() -> [&'static str; 4] {
        PredicateKind::DETERMINANTS.map(PredicateKind::name)
    }

    /// The arithmetic chosen for each of [`PredicateKind::DETERMINANTS`].
    #[must_use]
    pub fn choices(&self) -> [&str; 4] {
        [&self.orient2d, &self.orient3d, &self.incircle, &self.insphere]
    }

    /// The row of a scene with the arithmetic of each predicate, empty if the scene has no such predicate.
    #[must_use]
    pub fn new(scene: &PlannedScene, [lowest, bits]: [i32; 2], choice: impl FnMut(PredicateKind) -> String) -> Self {
        let [orient2d, orient3d, incircle, insphere] = PredicateKind::DETERMINANTS.map(choice);
        let PlannedScene { suite, scene, scene_id, .. } = scene.clone();
        PrecisionRow { suite, scene, scene_id, lowest, bits, orient2d, orient3d, incircle, insphere }
    }
}
