//! `phases.csv`: what the parts of an algorithm take, one by one.

use serde::{Deserialize, Serialize};

use crate::Row;

/// One timed sample of one phase of a scene.
///
/// Phases that ask no predicate, such as reading a file or making a grid, are timed once for all backends: `backend` is empty.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct PhaseRow {
    /// The suite's name.
    pub suite: String,
    /// The scene's name in its suite.
    pub scene: String,
    /// The scene's content id.
    pub scene_id: String,
    /// What was asked.
    pub task: String,
    /// How large the scene is, in what its task counts: the triangles of a mesh.
    pub size: u64,
    /// The backend's name, with its parameters; empty where no predicate is asked.
    pub backend: String,
    /// The number of threads.
    pub threads: u64,
    /// The phase: `grid`, `queries`, …
    pub phase: String,
    /// What is counted: `triangle`, `query`, …
    pub unit: String,
    /// How many of them there are.
    pub count: u64,
    /// The memory of what the phase has made, in bytes; none where that is not known.
    pub bytes: Option<u64>,
    /// The number of the sample, from 0.
    pub sample: u64,
    /// Nanoseconds of wall clock for one of them.
    pub ns_per_unit: f64,
}

impl Row for PhaseRow {
    const FILE: &'static str = "phases.csv";
    const COLUMNS: &'static [&'static str] = &[
        "suite",
        "scene",
        "scene_id",
        "task",
        "size",
        "backend",
        "threads",
        "phase",
        "unit",
        "count",
        "bytes",
        "sample",
        "ns_per_unit",
    ];

    fn check(&self) -> Result<(), String> {
        if self.count == 0 || self.threads == 0 {
            return Err("a phase of no units, or on no threads".to_owned());
        }
        if self.ns_per_unit.is_finite() && self.ns_per_unit > 0.0 {
            Ok(())
        } else {
            Err(format!("ns_per_unit is {}, which is not a time", self.ns_per_unit))
        }
    }
}
