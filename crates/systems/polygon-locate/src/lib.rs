//! In which region of a map does a point lie? (4.2)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`answer`]: what both the algorithm and the truth answer.
//! * [`truth`]: what is true about a scene, found without the algorithm.
//! * [`checks`]: what must hold for its answers, decided exactly.
//! * [`task`]: how it is asked, judged, drawn and reported.

pub mod algorithm;
pub mod answer;
pub mod checks;
pub mod task;
pub mod truth;
