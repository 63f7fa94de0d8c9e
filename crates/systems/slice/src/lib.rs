//! A mesh split by planes, its parts capped and triangulated (Rhodes)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`truth`]: where constructed vertices are, found without the algorithm.
//! * [`checks`]: what must hold for its answers, decided exactly.
//! * [`task`]: how it is asked, judged, drawn and reported.

pub mod algorithm;
pub mod checks;
pub mod task;
pub mod truth;
