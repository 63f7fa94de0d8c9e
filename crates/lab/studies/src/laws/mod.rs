//! Do answers about the same vertices fit each other, whatever the truth is?
//!
//! Scenes of a corpus are there for their errors; laws want ties. So here are
//! scenes of about a dozen vertices each, made to be degenerate in every way: small
//! grids with repeated points, lines, planes, circles, spheres, far from the
//! origin, with exponents mixed. First come some that are exhausted, every tuple of
//! them; then random ones, of which tuples are drawn.
//!
//! * [`Laws`]: the study.
//! * [`Family`]: the scenes.
//! * [`Check`]: a law about a predicate; [`checks`]: all there are.
//! * [`survey`]: a backend through all of it; [`Row`]: the counts of one law.

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
