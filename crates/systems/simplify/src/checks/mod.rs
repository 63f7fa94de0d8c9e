//! The steps of an answer, done again, and each decision compared with exact signs.
//!
//! [`Replay`] holds a plain list of triangles and the triangles around each vertex. It shares no code with half-edge
//! meshes. The link condition is here as Dey, Edelsbrunner, Guha and Nekhayev state it (1999, *Topology preserving edge
//! contraction*): the links of both ends have in common the link of the edge, and nothing else. A boundary is closed by
//! one more vertex, joined to all boundary edges.
//!
//! [`Facing`] is the truth about a face before and after a step, in rationals.

mod facing;
mod reached;
mod replay;

pub use facing::{Facing, facing};
pub use reached::{Chains, Reached};
pub use replay::{Obstacle, Replay};
