//! Floating-point error bounds by rules (Wang, Jiang, Schroeder and Teran,
//! section 2): ordinary code is written once, over [`Ring`] and [`Root`], and
//! runs on doubles, on rationals, and on numbers that carry their own error
//! bound.
//!
//! * [`Ring`], [`Field`], [`Root`]: what such code may do with a number.
//! * [`vector`]: differences, products and norms in a stated order of evaluation.
//! * [`Quantity`]: the number that carries (s, c, p, n, a, b, r, v).
//! * [`rules`]: what rules A to H do with a and b, and where the paper misprints.
//! * [`Perturbed`]: arithmetic as bad as the rules allow, to test them with.
//! * [`Enclosure`]: intervals of rationals, to decide what has roots in it.

mod enclosure;
mod magnitude;
mod number;
mod perturbed;
mod quantity;
pub mod rules;
pub mod vector;

pub use enclosure::Enclosure;
pub use magnitude::Magnitude;
pub use number::{Field, Ring, Root};
pub use perturbed::{Adversary, Perturbed};
pub use quantity::{Bound, Quantity};
