//! Exact arithmetic on doubles: exponent ranges, filter constants, integers, rationals.
//!
//! This crate has no geometry: it determines which computations on a given list of doubles make no error, and holds
//! exact arithmetic for the others. A [`Form`] describes the geometry: the degree of a polynomial in differences of
//! coordinates, and the growth of its intermediates.
//!
//! * [`Sign`]: the answer of a predicate.
//! * [`ExponentRange`]: the lowest bit and the highest exponent of a list.
//! * [`Plan`]: the consequences of that range for a [`Form`]; the proof is in its docs.
//! * [`bound`]: the constants of semi-static filters, and their derivation.
//! * [`Parts`]: a double as an integer times a power of two.
//! * [`Fixed`]: integers of a fixed size; [`dyadic`]: exact numbers, limbs times a power of two; [`Ball`]: doubles with
//!   a proved radius. All on the stack.
//! * [`BigInt`]: integers of any length.
//! * `rational`, `Scaled` (feature `gmp`): doubles as exact numbers of GMP.
//! * [`Number`]: the interface of numbers that the formulas of filters run on.
//! * [`difference_up`]: a difference rounded up, for lengths that bound others.

#![cfg_attr(not(test), no_std)]

extern crate alloc;

mod ball;
mod big;
pub mod bound;
pub mod dyadic;
#[cfg(any(test, feature = "gmp"))]
mod exact;
mod fixed;
mod number;
mod parts;
mod plan;
mod short;
mod sign;

pub use ball::Ball;
pub use big::BigInt;
#[cfg(any(test, feature = "gmp"))]
pub use exact::{Scaled, rational};
pub use fixed::Fixed;
pub use number::Number;
pub use parts::{Parts, power_of_two};
pub use plan::{Arithmetic, ExponentRange, Form, Plan, Span, difference_up, exact_tail, units};
pub use short::{exact_differences, short_rows};
pub use sign::Sign;
