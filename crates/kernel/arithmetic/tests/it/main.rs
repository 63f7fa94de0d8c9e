//! The integration tests, as one binary: each further one would link the crate and compile what they share again.

mod ball;
mod dyadic;
mod plan;
mod short;
