//! Volume, area and edge length of a union of cubes (4.3)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`truth`]: the truth about a scene, computed without the algorithm.
//! * [`checks`]: the properties that the answers must have, decided exactly.
//! * [`task`]: the task: its suites, judgement, drawing and report.

pub mod algorithm;
pub mod checks;
pub mod task;
pub mod truth;
