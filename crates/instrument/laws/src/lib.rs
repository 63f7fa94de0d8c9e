//! Laws between answers to related queries, and the published tolerances, decided exactly.
//!
//! The exact sign can judge a sign. Whole families of signs can also judge one another, without showing which single
//! answer was wrong. The laws for the output of a system are in the system's own crate.
//!
//! * [`axioms`]: laws between the answers to related queries.
//! * [`published`]: the tolerances of Wang et al., as printed and as they hold.

pub mod axioms;
pub mod published;
