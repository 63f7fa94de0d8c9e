//! The integration tests, as one binary: each further binary would link the crate and compile shared code again.

mod common;
mod hull_plane;
mod hull_signs;
mod hull_space;
mod judged;
