//! Laws between answers to related queries, and the published tolerances, decided exactly.
//!
//! A sign can be judged by the exact sign. Whole families of signs can also be
//! judged by one another, without knowing which single answer was wrong. What must
//! hold for the answer of a system is in the system's own crate.
//!
//! * [`axioms`]: laws between the answers to related queries.
//! * [`published`]: the tolerances of Wang et al., as they are printed and as they hold.

pub mod axioms;
pub mod published;
