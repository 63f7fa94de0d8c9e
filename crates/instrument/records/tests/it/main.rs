//! The integration tests, as one binary: each further binary would link the crate and compile shared code again.

mod earlier;
mod hostile;
mod junit;
mod once;
mod resumed;
mod run_dir;
mod schema;
