//! Cascades of meshes: what becomes of a mesh when the result of each Boolean operation is an operand of the next.
//!
//! A result has vertices where an edge passes through a triangle, and these are seldom doubles. Meshes that share faces are the other
//! trouble: a result with a sheet or a sliver left in it is an operand of the next step. Here thousands of steps
//! are done, and what is left is measured in rationals.
//!
//! * [`Cascade`] makes the steps. All operands are doubles that are known beforehand.
//! * A backend does them, as [`predicament_mesh_intersect::algorithm::cascade`] has it: the overlay by its signs, the limit by exact
//!   ones, then the nearest doubles. Where these make a result cross itself, it is resolved ([`predicament_mesh_intersect::algorithm::resolve`]).
//! * [`Sample`] is what is measured after a step.
//!
//! # What is true
//! Whether a point is in the result follows from the operands alone, one after the other, in rationals. Of cubes of a lattice the
//! volume, the area and the number of squares are counted.

mod cascade;
mod sample;
mod study;
mod survey;
mod table;

pub use cascade::{Cascade, Operand};
pub use sample::{Done, Sample};
pub use study::{Measured, MeshCascades, Rounding};
pub use survey::Followed;
