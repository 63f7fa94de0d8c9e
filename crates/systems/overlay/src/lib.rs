//! Arrangements of segments, Boolean operations on polygons, and snap rounding (Rhodes; Hobby)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`answer`]: the Boolean operations, for all other modules.
//! * [`truth`]: the truth about a scene, found without the algorithm.
//! * [`checks`]: exact checks of the answers.
//! * [`task`]: the tasks: scenes, judging, drawing and report.

pub mod algorithm;
pub mod answer;
pub mod checks;
pub mod task;
pub mod truth;
