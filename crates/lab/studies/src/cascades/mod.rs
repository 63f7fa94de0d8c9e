//! Cascades: what becomes of a polygon when the result of each Boolean operation is an operand of the next.
//!
//! A crossing of two edges is seldom a double. A program that rounds it moves two edges by a little, and the moved edges cross
//! others that they did not cross before; with each step there is more of that (Rhodes, *Computational Geometry*, the slides
//! on cascades of extraneous intersections). Here the same steps are done by several [methods](Method), and after them everything
//! is measured in rationals.
//!
//! * [`Cascade`] makes the steps. All operands are doubles that are known beforehand, so that each method has the same task.
//! * A [`Method`] does them: constructed vertices kept whole, or rounded, or snapped after each step, thick primitives, contacts
//!   of the tolerance scheme.
//! * [`Sample`] is what is measured after a step.
//!
//! # What is true
//! Whether a point is in the result follows from the operands alone, one after the other; a sample locates
//! [points](Sample::lost) in rationals. The area that the others are held against is that of the exact method, whose points and
//! loops pass the same measurements.

mod cascade;
mod contradiction;
mod current;
mod method;
mod plots;
mod rounded;
mod sample;
mod settled;
mod snapped;
mod step;
mod study;
mod survey;
mod table;
mod whole;

pub use cascade::{Cascade, Operand};
pub use contradiction::Contradiction;
pub use method::{Keep, Method, ParseMethodError};
pub use sample::Sample;
pub use study::{Cascades, Measured};
pub use survey::{Followed, Plan};
