//! The integration tests, as one binary, because each further binary would link the crate and compile shared code
//! again.

mod ball;
mod dyadic;
mod fixed;
mod plan;
mod short;
