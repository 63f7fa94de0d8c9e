//! What a cut of a tetrahedral mesh by a surface is worth, by the contacts that each backend registers.
//!
//! This is what the tolerance paper's scheme is for: a lattice of tetrahedra is
//! cut by a triangulated surface, and everything that is known about the cut is
//! what was registered: vertices of the lattice on the surface, points where
//! its edges pass through the surface, and vertices of the surface in its
//! tetrahedra (Algorithm 12). A wrong registration makes a tetrahedron that
//! cannot be cut, or a part that comes apart.
//!
//! * [`Cut`]: the study; [`Scene`]: a lattice and a surface with a known volume.
//! * [`Pieces`]: tetrahedra cut by contacts; [`Exactly`]: what some of them should have inside, in rationals.

mod exactly;
mod measured;
mod pieces;
mod sides;
mod study;
mod surfaces;
mod table;
mod volume;

pub use exactly::{Deviation, Exactly, ROUNDING};
pub use measured::{Cut, Made, Measured, Row};
pub use pieces::{Pieces, SLIVER, pieces};
pub use sides::{Sides, sides};
pub use surfaces::{Placement, Scene, Shape};
