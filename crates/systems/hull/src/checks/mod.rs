//! Convex hulls held to what a convex hull is.
//!
//! Signs are decided by sessions that are handed in: exact ones, and where ties are broken those of the perturbed scene.
//! Nothing of the algorithms is used here: no chain, no conflict graph, no half-edge.
//!
//! # In the plane
//! A closed polygon that turns to the left at every vertex and goes around once is convex. Then a point is inside if it
//! is above the edges below it and below those above it: two or three signs each, for every point.
//!
//! # In space
//! Faces that close to a connected surface, with V − E + F = 2, flat and convex, and convex at every edge, are not yet
//! the surface of a convex body: two pyramids over a pentagram pass all of that. So the surface must also be wound around
//! an inner point once: a ray from there meets it in one place only (Mehlhorn et al., *Checking geometric programs*,
//! 1999). Both together are a proof, in linear time. Points that are no vertices are held against every face, all of
//! them or a sample.
//!
//! # Where ties are broken
//! A turn of zero is legal where the perturbed turn has the right sign; an even sample of such turns is decided. Faces of
//! no area and coplanar faces are legal then.

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
