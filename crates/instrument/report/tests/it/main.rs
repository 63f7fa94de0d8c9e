//! The integration tests, as one binary: each further binary would link the crate and compile shared code again.

mod against;
mod figures;
mod pages;
mod pdf;
