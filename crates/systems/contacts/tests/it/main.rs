//! The integration tests, as one binary: each further binary would link the crate and compile shared code again.

mod audit;
mod common;
mod contacts;
mod contacts_by_signs;
mod contacts_driver;
mod judged;
mod thick;
