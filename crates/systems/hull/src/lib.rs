//! Convex hulls in the plane and in space (Rhodes)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`truth`]: what is true about a scene, found without the algorithm.
//! * [`checks`]: what must hold for its answers, decided exactly.
//! * [`task`]: how it is asked, judged, drawn and reported.

pub mod algorithm;
pub mod checks;
pub mod task;
pub mod truth;
