//! The integration tests, as one binary, because each further binary would link the crate and compile shared code
//! again.

mod adversary;
mod anywhere;
mod bounds;
mod common;
mod constructed;
mod dyadic;
mod equality;
mod every;
mod exponents;
mod formulas;
mod left_open;
mod partial;
#[path = "../rational/mod.rs"]
mod rational;
mod session;
mod toy;
mod truth;
mod without;
