//! `phases.csv`: the time and memory of the phases of an algorithm.
use crate::RowError;

crate::table! {
    /// `phases.csv`: one timed sample of one phase of a scene.
    ///
    /// Phases that ask no predicate, such as reading a file or making a grid, are timed once for all backends:
    /// `backend` is empty.
    pub struct PhaseRow [Clone, PartialEq, Debug] in "phases.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// What was asked.
        pub task: String,
        /// How large the scene is, in what its task counts: the triangles of a mesh.
        pub size: u64 ["what the task counts"],
        /// The backend's name, with its parameters; empty where no predicate is asked.
        pub backend: String,
        /// The number of threads.
        pub threads: u64 ["threads"],
        /// The phase: `grid`, `queries`, …
        pub phase: String,
        /// What is counted: `triangle`, `query`, …
        pub unit: String,
        /// How many of them there are.
        pub count: u64,
        /// The memory of what the phase has made, in bytes; none where that is not known.
        pub bytes: Option<u64> ["bytes"],
        /// The number of the sample, from 0.
        pub sample: u64 ["place"],
        /// Nanoseconds of wall clock for one of them.
        pub ns_per_unit: f64 ["ns"],
    }

    fn check(&self) -> Result<(), RowError> {
        if self.count == 0 || self.threads == 0 {
            return Err(RowError::Contradiction("a phase of no units, or on no threads"));
        }
        RowError::check_time("ns_per_unit", self.ns_per_unit)
    }
}
