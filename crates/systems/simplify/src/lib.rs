//! A mesh with fewer triangles: edges collapse, the cheapest first, and no face turns over.
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`answer`]: the steps and the triangles; algorithm, checks and judge share them.
//! * [`truth`]: the topology of a mesh, computed without the algorithm.
//! * [`checks`]: the steps of an answer, done again on a plain list of triangles, in rationals.
//! * [`task`]: the task: its suites, judgement, drawing and files.

pub mod algorithm;
pub mod answer;
pub mod checks;
pub mod task;
pub mod truth;
