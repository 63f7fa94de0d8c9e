//! Derivations of the paper's figures: its error bounds, constraints and defined tolerances.
//!
//! They cover every error bound of sections 4 and 5, every constraint on its tolerances, and every tolerance that a
//! constraint defines.
//!
//! * [`quantities`]: the compared quantities of each section, over any number type.
//! * [`algorithms`]: Algorithms 1 and 6, over any number type.
//! * [`published`]: the paper's statements; [`Derivation`]: a statement beside the result of the calculus.
//! * [`coefficient`]: the two tables of tolerances as exact numbers.
//! * [`constraints`]: the constraints, decided at one ε at a time.
//! * [`decimal`]: exact numbers in print.
//! * [`height`]: section 5.4.4, whose argument is a chain of inequalities.
//!
//! Rounding decides nothing here: coefficients are rational multiples of 1 and √3, ε is rational, and rationals enclose
//! ε^¼ and all other roots.

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
