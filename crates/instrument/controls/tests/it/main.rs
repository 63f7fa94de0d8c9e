//! The integration tests, as one binary: each further one would link the crate and compile what they share again.

mod batches;
mod controls;
