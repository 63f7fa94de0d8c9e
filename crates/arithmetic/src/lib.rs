//! What exactness is made of: exponent ranges, filters, rationals.
//!
//! This crate knows numbers and not geometry: it says which computations on a
//! given list of doubles can be trusted, and holds the arithmetic for those
//! that can't. Geometry comes in as a [`Form`]: the degree of a polynomial in
//! differences of coordinates, and how far its intermediates grow.
//!
//! * [`ExponentRange`]: the lowest bit and the highest exponent of a list.
//! * [`Plan`]: what that range proves about a [`Form`]; the proof is in its docs.
//! * [`bound`]: the constants of semi-static filters, and where they come from.
//! * [`rational`], [`Scaled`]: doubles as exact numbers.

pub mod bound;
mod exact;
mod plan;
mod range;

pub use exact::{Scaled, rational};
pub use plan::{Form, Plan, Regime};
pub use range::ExponentRange;
