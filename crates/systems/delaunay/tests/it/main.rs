//! The integration tests, as one binary: each further one would link the crate and compile what they share again.

mod common;
mod delaunay;
mod delaunay_signs;
mod judged;
