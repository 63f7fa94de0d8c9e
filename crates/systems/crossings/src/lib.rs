//! Crossings of segments, and their order along each segment.
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`truth`]: the truth about a scene, computed without the algorithm.
//! * [`task`]: the task: its suites, judgement, drawing and report.

pub mod algorithm;
pub mod task;
pub mod truth;
