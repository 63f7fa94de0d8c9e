//! Cascades: the effects on a polygon if the result of each Boolean operation is an operand of the next.
//!
//! A crossing of two edges is rarely a double. A program that rounds it moves two edges slightly, and the moved edges
//! cross others that they did not cross before; the effect grows with each step (Rhodes, *Computational Geometry*, the
//! slides on cascades of extraneous intersections). Here several [methods](Method) do the same steps, and the results
//! are measured in rationals.
//!
//! * [`Cascade`] makes the steps. All operands are doubles that are known in advance, so each method has the same task.
//! * A [`Method`] does them: constructed vertices kept whole, or rounded, or snapped after each step, thick primitives,
//!   contacts of the tolerance scheme.
//! * [`Sample`] holds the measurements after a step.
//!
//! # The truth
//! The operands alone determine whether a point is in the result, one after the other; a sample locates
//! [points](Sample::lost) in rationals. The reference area is that of the exact method, whose points and loops pass the
//! same measurements.

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
