//! Which simplices of two complexes meet, and how are they merged? (Wang et al.)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`checks`]: what must hold for its answers, decided exactly.
//! * [`task`]: how it is asked, judged, drawn and reported.

pub mod algorithm;
pub mod checks;
pub mod task;
