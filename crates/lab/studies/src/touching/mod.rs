//! The study of solids that touch: what each philosophy returns, and what the return costs.
//!
//! Simulation of Simplicity exists to avoid the special cases of contact. A backend whose zeros mean zero has them
//! written out. So three ways answer one question: the cases, a perturbed result, and a perturbed result followed by
//! its limit. The study times the three ways on the same pairs of solids and counts what only one of them returns:
//! contacts (the cases), triangles without area and sheets without volume (the perturbation).
//!
//! * [`Touching`]: the study; [`Pair`]: two solids whose contact is known by counting.
//! * [`Known`]: the counted truth; [`Made`]: the result of one backend.
//!
//! # The truth
//! Pairs are made of unit cubes, so volumes and contacts are counted. Volumes of results are computed in rationals.

mod made;
mod measured;
mod pair;
mod study;
mod suite;
mod table;

pub use made::{Made, Touched, Volume};
pub use measured::{Measured, Row, Touching};
pub use pair::{Known, Pair};
