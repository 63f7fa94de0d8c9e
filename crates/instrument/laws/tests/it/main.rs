//! The integration tests, as one binary: each further one would link the crate and compile what they share again.

mod axioms;
#[allow(dead_code, reason = "tilings are tried with more faults")]
mod common;
mod constructs;
