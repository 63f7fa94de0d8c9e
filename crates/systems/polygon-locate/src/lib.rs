//! Location of points in the regions of a map (4.2)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`answer`]: the type of the algorithm's answers and of the truth.
//! * [`truth`]: the truth about a scene, found without the algorithm.
//! * [`checks`]: exact checks of the answers.
//! * [`task`]: the task: scenes, judging, drawing and report.

pub mod algorithm;
pub mod answer;
pub mod checks;
pub mod task;
pub mod truth;
