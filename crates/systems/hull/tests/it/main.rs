//! The integration tests, as one binary: each further one would link the crate and compile what they share again.

mod common;
mod hull_plane;
mod hull_signs;
mod hull_space;
mod judged;
