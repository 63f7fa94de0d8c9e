//! The integration tests, as one binary: each further one would link the crate and compile what they share again.

mod against;
mod figures;
mod pages;
mod pdf;
