//! Boolean operations on meshes, and what becomes of results in doubles (3D-EPUG-Overlay, 4.5)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`task`]: how it is asked, judged, drawn and reported.

pub mod algorithm;
pub mod task;
