//! Locating points in the cells of a line (Franklin and Magalhães, 4.1)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`answer`]: the type of answers that these modules share.
//! * [`truth`]: the truth about a scene, computed without the algorithm.
//! * [`checks`]: the properties that the answers must have, decided exactly.
//! * [`task`]: the task: its suites, judgement, drawing and report.

pub mod algorithm;
pub mod answer;
pub mod checks;
pub mod task;
pub mod truth;
