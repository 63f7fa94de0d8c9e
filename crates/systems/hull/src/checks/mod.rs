//! Exact checks of convex hulls.
//!
//! The caller provides the sessions that decide signs: exact ones and, if ties are broken, those of the perturbed
//! scene. The checks share nothing with the algorithms: no chain, no conflict graph, no half-edge.
//!
//! # In the plane
//! A closed polygon that turns to the left at every vertex and goes around once is convex. Then a point is inside if it
//! is above the edges below it and below the edges above it: two or three signs for each point.
//!
//! # In space
//! A surface can be closed and connected, with V − E + F = 2, flat and convex faces, and be convex at every edge, and
//! still not bound a convex body. Two pyramids over a pentagram pass all these checks. So the surface must also be
//! wound once around an inner point: a ray from there meets it in one place only (Mehlhorn et al., *Checking geometric
//! programs*, 1999). Both together are a proof, in linear time. Points that are not vertices are checked against every
//! face, all of them or a sample.
//!
//! # With broken ties
//! A turn of zero is legal if the perturbed turn has the right sign; an even sample of such turns is decided. Faces of
//! zero area and coplanar faces are then legal.

mod closed;
mod plane;
mod space;
mod tally;
mod wound;

pub use plane::plane_flaws;
pub use plane::ring;
pub use space::space_flaws;
pub use tally::Tally;
pub use tally::{Flaw, Signs};
