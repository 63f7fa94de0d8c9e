//! Which simplices of two complexes meet, and how are they merged? (Wang et al.)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`answer`]: what is registered and merged, for all of these.
//! * [`truth`]: what is true about a scene, found without the algorithm.
//! * [`checks`]: what must hold for its answers, decided exactly.
//! * [`task`]: how it is asked, judged, drawn and reported.

pub mod algorithm;
pub mod answer;
pub mod checks;
pub mod task;
pub mod truth;
