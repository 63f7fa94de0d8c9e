//! Arrangements of segments, Boolean operations on polygons, and snap rounding (Rhodes; Hobby)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`answer`]: the operations, for all of these.
//! * [`truth`]: what is true about a scene, found without the algorithm.
//! * [`checks`]: what must hold for its answers, decided exactly.
//! * [`task`]: how it is asked, judged, drawn and reported.

pub mod algorithm;
pub mod answer;
pub mod checks;
pub mod task;
pub mod truth;
