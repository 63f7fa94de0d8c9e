//! Delaunay triangulations in the plane, with constraints (Shewchuk)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`truth`]: the extent of the checks, as the checks themselves are the truth.
//! * [`checks`]: the properties that the answers must have, decided exactly.
//! * [`task`]: the task: its suites, judgement, drawing and report.

pub mod algorithm;
pub mod checks;
pub mod task;
pub mod truth;
