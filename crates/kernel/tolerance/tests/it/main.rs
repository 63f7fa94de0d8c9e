//! The integration tests, as one binary, because each further binary would link the crate and compile shared code
//! again.

mod backend;
mod band;
mod batches;
mod bounds;
mod constraints;
mod contacts;
mod shift;
mod steps;
