//! Contacts of two simplicial complexes, and merging by them (Wang et al.)
//!
//! * [`algorithm`]: the algorithm, generic over the session.
//! * [`answer`]: the types of contacts and merged complexes that these modules share.
//! * [`truth`]: the truth about a scene, computed without the algorithm.
//! * [`checks`]: the properties that the answers must have, decided exactly.
//! * [`task`]: the tasks: their suites, judgement, drawing and report.

pub mod algorithm;
pub mod answer;
pub mod checks;
pub mod task;
pub mod truth;
