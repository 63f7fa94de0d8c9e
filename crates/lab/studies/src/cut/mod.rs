//! The study of cuts: the quality of a tetrahedral mesh that a surface cuts, by the contacts of each backend.
//!
//! This is the purpose of the tolerance paper's scheme: a triangulated surface cuts a lattice of tetrahedra, and only
//! the registered contacts determine the cut. They are vertices of the lattice on the surface, points where its edges
//! pass through the surface, and vertices of the surface in its tetrahedra (Algorithm 12). A wrong registration makes a
//! tetrahedron that cannot be cut, or a separated part.
//!
//! * [`Cut`]: the study; [`Scene`]: a lattice and a surface with a known volume.
//! * [`Pieces`]: tetrahedra cut by contacts; [`Exactly`]: the exact inside shares of some of them, in rationals.

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
