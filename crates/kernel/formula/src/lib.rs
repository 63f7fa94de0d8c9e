//! Predicates from formulas: one polynomial, and all that a robust predicate needs, derived from it.
//!
//! A predicate is the sign of a polynomial in the coordinates of a few points. This crate reads the polynomial as text
//! and derives, by programs that anyone can read,
//! * [`Filter`]: the error bound of its estimate in doubles, static and semi-static, for any finite doubles;
//! * [`Bits`]: the integers that hold it;
//! * [`exact`]: its sign without rounding;
//! * [`Terms`]: the ordered terms of Simulation of Simplicity;
//! * [`Polynomial`]: its degree, and the permutations of arguments that keep or turn its sign.
//!
//! `docs/FORMULAS.md` explains each derivation. The crate has no geometry and knows no scene: coordinates are slices.

mod bits;
mod catalogue;
pub mod exact;
mod filter;
mod formula;
mod interpret;
mod lower;
mod polynomial;
mod program;
mod shipped;
mod syntax;
mod terms;
pub mod write;

pub use bits::Bits;
pub use catalogue::{CATALOGUE, Entry};
pub use filter::{Accuracy, Error, Filter, Slack};
pub use formula::{Definition, Formula, MOST_COORDINATES, MOST_POINTS, Swap};
pub use interpret::{Ring, interpret};
pub use lower::lower;
pub use polynomial::{Exponents, Polynomial};
pub use program::{Builder, Op, Program};
pub use syntax::{Expression, FormulaError, Function, Node, Span, Syntax, WEIGHT, parse};
pub use terms::{Order, Terms};
