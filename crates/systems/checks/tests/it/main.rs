//! The integration tests, as one binary: each further one would link the crate and compile what they share again.

mod audit;
mod axioms;
mod common;
mod constructs;
mod contacts;
mod cubes;
mod delaunay;
mod hull;
mod names;
mod overlay;
mod partition;
mod slice;
mod snap;
mod tiling;
mod triangulation;
