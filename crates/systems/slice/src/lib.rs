//! A mesh split by planes, its parts capped and triangulated (Rhodes)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`truth`]: the positions of constructed vertices, found without the algorithm.
//! * [`checks`]: exact checks of the answers.
//! * [`task`]: the task: scenes, judging, drawing and report.

pub mod algorithm;
pub mod checks;
pub mod task;
pub mod truth;
