//! The integration tests in one binary: each further binary would link the crate and compile shared code again.

mod batches;
mod controls;
mod grid;
mod rational;
