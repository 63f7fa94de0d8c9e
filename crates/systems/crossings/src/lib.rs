//! Which segments cross, and in which order along each other?
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`task`]: how it is asked, judged, drawn and reported.

pub mod algorithm;
pub mod task;
