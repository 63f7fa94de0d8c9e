//! Arrangements of segments, Boolean operations on polygons, and snap rounding (Rhodes; Hobby)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`checks`]: what must hold for its answers, decided exactly.
//! * [`task`]: how it is asked, judged, drawn and reported.

pub mod algorithm;
pub mod checks;
pub mod task;
