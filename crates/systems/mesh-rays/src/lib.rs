//! Lines, rays and segments against a mesh: the vertices, edges and faces that they hit, in order.
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`answer`]: hits, and the part of a line that counts; algorithm, truth and judge share them.
//! * [`truth`]: the truth about a scene, computed without the algorithm.
//! * [`task`]: the task: its suites, judgement, drawing and files.

pub mod algorithm;
pub mod answer;
pub mod task;
pub mod truth;
