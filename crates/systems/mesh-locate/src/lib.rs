//! Location of points in multi-material meshes (PinMesh, 4.4)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`truth`]: the truth about a scene, found without the algorithm.
//! * [`task`]: the task: scenes, judging, drawing and report.

pub mod algorithm;
pub mod task;
pub mod truth;
