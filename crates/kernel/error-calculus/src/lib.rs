//! Floating-point error bounds by rules (Wang, Jiang, Schroeder and Teran, section 2).
//!
//! Ordinary code is written once, over [`Ring`] and [`Root`]. It runs on doubles, on rationals, and on numbers that
//! carry their own error bound.
//!
//! * [`Ring`], [`Field`], [`Root`]: the operations that such code may use.
//! * [`vector`]: differences, products and norms in a stated order of evaluation.
//! * [`Quantity`]: the number that carries (s, c, p, n, a, b, r, v).
//! * [`rules`]: the effect of rules A to H on a and b, and the paper's misprints.
//! * [`Perturbed`]: arithmetic with the largest errors that the rules allow, for tests.
//! * [`Enclosure`]: intervals of rationals, to decide statements with roots.

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
