//! The laws of predicates on tuples by the million.
//!
//! Scenes of a corpus are there for their errors; laws want ties. So here are
//! scenes of about a dozen vertices each, made to be degenerate in every way: small
//! grids with repeated points, lines, planes, circles, spheres, far from the
//! origin, with exponents mixed. First come some that are exhausted, every tuple of
//! them; then random ones, of which tuples are drawn.
//!
//! * [`Family`]: the scenes.
//! * [`Check`]: a law about a predicate; [`checks`]: all there are.
//! * [`survey`]: a backend through all of it; [`Row`]: what came of one law.

mod check;
mod family;
mod row;
mod survey;

pub use check::{Check, checks};
pub use family::Family;
pub use row::{Example, Row};
pub use survey::{Survey, survey};
