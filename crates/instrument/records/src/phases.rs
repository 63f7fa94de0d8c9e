//! `phases.csv`: the time and memory of the phases of an algorithm.
use crate::RowError;

crate::table! {
    /// `phases.csv`: one timed sample of one phase of a scene.
    ///
    /// Phases that call no predicate, such as reading a file or making a grid, are timed once for all backends; their
    /// `backend` is empty.
    pub struct PhaseRow [Clone, PartialEq, Debug] in "phases.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// The task.
        pub task: String,
        /// The size of the scene, in the unit of its task, such as triangles of a mesh.
        pub size: u64 ["what the task counts"],
        /// The backend's name, with its parameters; empty if the phase calls no predicate.
        pub backend: String,
        /// The number of threads.
        pub threads: u64 ["threads"],
        /// The phase: `grid`, `queries`, …
        pub phase: String,
        /// The unit that is counted: `triangle`, `query`, …
        pub unit: String,
        /// The number of units.
        pub count: u64,
        /// The memory of the phase's result, in bytes; null if unknown.
        pub bytes: Option<u64> ["bytes"],
        /// The number of the sample, from 0.
        pub sample: u64 ["place"],
        /// Nanoseconds of wall time per unit.
        pub ns_per_unit: f64 ["ns"],
    }

    fn check(&self) -> Result<(), RowError> {
        if self.count == 0 || self.threads == 0 {
            return Err(RowError::Contradiction("a phase with 0 units or 0 threads"));
        }
        RowError::check_time("ns_per_unit", self.ns_per_unit)
    }
}
