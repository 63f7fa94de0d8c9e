//! The integration tests, as one binary: each further one would link the crate and compile what they share again.

mod adversary;
mod anywhere;
mod bounds;
mod common;
mod constructed;
mod dyadic;
mod equality;
mod exponents;
mod left_open;
mod partial;
mod session;
mod truth;
