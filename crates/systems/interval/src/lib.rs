//! In which cell of a line does a point lie? (Franklin and Magalhães, 4.1)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`answer`]: what all of these call an answer.
//! * [`truth`]: what is true about a scene, found without the algorithm.
//! * [`checks`]: what must hold for its answers, decided exactly.
//! * [`task`]: how it is asked, judged, drawn and reported.

pub mod algorithm;
pub mod answer;
pub mod checks;
pub mod task;
pub mod truth;
