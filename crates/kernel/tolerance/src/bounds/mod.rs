//! The paper's figures, derived: every error bound of sections 4 and 5, every
//! constraint on its tolerances, every tolerance that a constraint defines.
//!
//! * [`quantities`]: what the algorithms compare, by section, over any number.
//! * [`algorithms`]: Algorithms 1 and 6, over any number.
//! * [`published`]: what the paper states, and [`Derivation`]: that beside what
//!   the calculus gives.
//! * [`coefficient`]: the two tables of tolerances as exact numbers.
//! * [`constraints`]: the constraints, decided at one ε at a time.
//! * [`decimal`]: exact numbers in print.
//! * [`height`]: section 5.4.4, whose argument is a chain of inequalities.
//!
//! Nothing here is decided by rounding: coefficients are rational multiples of 1
//! and √3, ε is rational, ε^¼ and all other roots are enclosed by rationals.

pub mod algorithms;
pub mod coefficient;
mod constraint;
pub mod constraints;
pub mod decimal;
mod derivation;
pub mod height;
pub mod published;
pub mod quantities;

pub use derivation::{Derivation, Verdict, derivations, other_orders};
