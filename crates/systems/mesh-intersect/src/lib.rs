//! Boolean operations on meshes, and what becomes of results in doubles (3D-EPUG-Overlay, 4.5)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`answer`]: the overlay as it is answered, for all of these.
//! * [`truth`]: where its vertices are, found without the algorithm.
//! * [`checks`]: what must hold for its answers, decided exactly.
//! * [`task`]: how it is asked, judged, drawn and reported.

pub mod algorithm;
pub mod answer;
pub mod checks;
pub mod task;
pub mod truth;
