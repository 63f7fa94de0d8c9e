//! Which segments cross, and in which order along each other?
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`truth`]: what is true about a scene, found without the algorithm.
//! * [`task`]: how it is asked, judged, drawn and reported.

pub mod algorithm;
pub mod task;
pub mod truth;
