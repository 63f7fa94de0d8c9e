//! Floating-point error bounds by rules (Wang, Jiang, Schroeder and Teran,
//! section 2): ordinary code is written once, over [`Ring`] and [`Root`], and
//! runs on doubles, on rationals, and on numbers that carry their own error
//! bound.
//!
//! * [`Ring`], [`Field`], [`Root`]: what such code may do with a number.
//! * [`vector`]: differences, products and norms in a stated order of evaluation.

mod number;
pub mod vector;

pub use number::{Field, Ring, Root};
