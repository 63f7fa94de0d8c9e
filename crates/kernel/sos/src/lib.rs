//! Simulation of Simplicity: every vertex moves by a separate infinitesimal, so no determinant of distinct vertices is
//! zero.
//!
//! The exact backend answers first; only if it answers zero, the perturbation is evaluated. Then the vertices are
//! sorted by their *identity* (the index in the scene, never the place in the argument list), and the terms of the
//! perturbed determinant are evaluated from the largest infinitesimal down until one is not zero. All answers about a
//! scene are those of one and the same moved scene, so they can't contradict each other.
//!
//! * [`Scheme`]: the infinitesimal of each coordinate.
//! * [`Sos`], [`Session`]: the backend; [`PerMesh`]: a backend that moves one of two meshes as a whole.
//! * `derive` (feature `gmp`): the program that derives the terms; [`Scheme::terms`] returns its output. [`Term`]: one
//!   term, as data.
//! * [`ties`]: sorting and evaluating, public for experiments and planted faults.
//! * `infinitesimal` (feature `gmp`): the same answers by explicit polynomials in ε, independent of the terms: the
//!   judge. It computes in numbers of GMP, and shares no arithmetic with the backend.

mod backend;
mod batch;
mod breaker;
mod constructed;
mod crossed;
mod deep;
#[cfg(test)]
mod definition;
#[cfg(feature = "gmp")]
pub mod derive;
#[cfg(feature = "formulas")]
mod derived;
mod filter;
mod gradient;
#[cfg(feature = "gmp")]
pub mod infinitesimal;
mod integer;
mod lanes;
mod leading;
mod lift;
mod per_mesh;
mod scheme;
mod session;
mod shift;
mod short;
mod stage;
#[rustfmt::skip]
mod tables;
mod term;
pub mod ties;
mod whole;

pub use backend::Sos;
pub use constructed::{Limit, Ratio, limit};
pub use per_mesh::PerMesh;
pub use scheme::Scheme;
pub use session::Session;
pub use term::{Gap, Lift, Term};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
