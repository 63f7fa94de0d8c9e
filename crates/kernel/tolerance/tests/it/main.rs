//! The integration tests, as one binary: each further one would link the crate and compile what they share again.

mod backend;
mod band;
mod batches;
mod bounds;
mod constraints;
mod contacts;
mod steps;
