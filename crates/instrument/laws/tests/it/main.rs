//! The integration tests in one binary: each further binary would link the crate and compile shared code again.

mod axioms;
#[allow(dead_code, reason = "tilings are tried with more faults")]
mod common;
mod constructs;
mod formula_bands;
