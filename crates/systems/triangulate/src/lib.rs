//! Triangulation of polygons with holes, by ear clipping and by a plane sweep (Rhodes)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`truth`]: the truth about a scene, found without the algorithm.
//! * [`checks`]: exact checks of the answers.
//! * [`task`]: the task: scenes, judging, drawing and report.

pub mod algorithm;
pub mod checks;
pub mod task;
pub mod truth;
