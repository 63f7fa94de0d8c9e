//! Covers of loops in space: triangles that close the holes of a mesh, with the least area and without a crossing.
//!
//! * [`algorithm`]: the algorithm, by a session's signs.
//! * [`answer`]: covers; algorithm, checks and judge share them.
//! * [`truth`]: exact areas, exact crossings, and a search of all covers, computed without the algorithm.
//! * [`checks`]: the laws for a cover.
//! * [`task`]: the task: its suites, judgement, drawing and files.

pub mod algorithm;
pub mod answer;
pub mod checks;
pub mod task;
pub mod truth;
