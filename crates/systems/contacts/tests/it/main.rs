//! The integration tests, as one binary: each further one would link the crate and compile what they share again.

mod audit;
mod common;
mod contacts;
mod contacts_by_signs;
mod contacts_driver;
mod judged;
mod thick;
