//! The integration tests, as one binary: each further binary would link the crate and compile shared code again.

mod common;
mod delaunay;
mod delaunay_signs;
mod judged;
