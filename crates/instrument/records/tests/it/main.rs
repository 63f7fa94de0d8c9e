//! The integration tests, as one binary: each further one would link the crate and compile what they share again.

mod hostile;
mod junit;
mod once;
mod resumed;
mod run_dir;
mod schema;
