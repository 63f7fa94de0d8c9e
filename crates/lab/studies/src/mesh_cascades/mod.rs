//! Cascades of meshes: the effects on a mesh if the result of each Boolean operation is an operand of the next.
//!
//! A result has vertices where an edge passes through a triangle, and these are rarely doubles. Meshes that share faces
//! are the second difficulty: a result with a remaining sheet or sliver is an operand of the next step. The study does
//! thousands of steps, and measures the results in rationals.
//!
//! * [`Cascade`] makes the steps. All operands are doubles that are known in advance.
//! * A backend does them with [`predicament_mesh_intersect::algorithm::cascade`]: the overlay by its signs, the limit
//!   by exact ones, then the nearest doubles. If these make a result cross itself, it is resolved
//!   ([`predicament_mesh_intersect::algorithm::resolve`]).
//! * [`Sample`] holds the measurements after a step.
//!
//! # The truth
//! The operands alone determine whether a point is in the result, one after the other, in rationals. For cubes of a
//! lattice the volume, the area and the number of squares are counted.

mod cascade;
mod sample;
mod study;
mod survey;
mod table;

pub use cascade::{Cascade, Operand};
pub use sample::{Done, Sample};
pub use study::{Measured, MeshCascades, Rounding};
pub use survey::Followed;
