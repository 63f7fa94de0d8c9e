//! Boolean operations on meshes, and their results in doubles (3D-EPUG-Overlay, 4.5)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`answer`]: the type of the overlay's answer, for all other modules.
//! * [`truth`]: the positions of its vertices, found without the algorithm.
//! * [`checks`]: exact checks of the answers.
//! * [`task`]: the task: scenes, judging, drawing and report.

pub mod algorithm;
pub mod answer;
pub mod checks;
pub mod task;
pub mod truth;
