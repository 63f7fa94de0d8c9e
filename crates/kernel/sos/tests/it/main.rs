//! The integration tests, as one binary, because each further binary would link the crate and compile shared code
//! again.

mod batches;
mod certain;
mod common;
mod constructed;
mod judged;
mod laws;
mod limits;
mod per_mesh;
mod per_mesh_range;
mod substitution;
mod tables;
