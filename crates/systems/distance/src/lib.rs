//! The minimum distance of two objects: how near they are, and which of their features are nearest.
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`answer`]: objects, features and nearest pairs; algorithm, truth and judge share them.
//! * [`truth`]: the truth about a scene, computed without the algorithm.
//! * [`task`]: the task: its suites, judgement, drawing and files.

pub mod algorithm;
pub mod answer;
pub mod task;
pub mod truth;
