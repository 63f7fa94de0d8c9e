//! The study of laws: whether answers about the same vertices fit each other, whatever the truth is.
//!
//! Scenes of a corpus are made to expose errors; laws need ties. So this study has scenes of about a dozen vertices
//! each, made to be degenerate in every way: small grids with repeated points, lines, planes, circles, spheres, far
//! from the origin, with mixed exponents. The first scenes are exhausted, every tuple of them; the others are random,
//! with random tuples.
//!
//! * [`Laws`]: the study.
//! * [`Family`]: the scenes.
//! * [`Check`]: a law about a predicate; [`checks`]: all laws.
//! * [`survey`]: checks all laws on a backend; [`Row`]: the counts of one law.

mod check;
mod family;
mod row;
mod study;
mod survey;
mod table;

pub use check::{Check, checks};
pub use family::Family;
pub use row::{Example, Row};
pub use study::{Format, Laws, Surveyed};
pub use survey::{Survey, survey};
