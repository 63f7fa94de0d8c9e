//! Proofs that a machine checks: the constants of filters and the bounds of tolerances.
//!
//! The functions that `predicament-exact` and `predicament-tolerance` evaluate are written over any numbers. Here
//! they run on symbols ([`trace`]), and the graph of their operations becomes a chain of scripts for Gappa
//! ([`rules`], [`chain`]). Code and proof share one definition of each formula.
//!
//! * [`filters`]: the constants of `exact`, for static, semi-static, constructed filters and for any doubles.
//! * [`linear`]: the filter of constructed vertices whose bound is linear in the slacks.
//! * [`approximations`]: the errors of constructed vertices.
//! * [`tolerances`]: the errors that the tolerances have to exceed.
//! * [`overflow`]: what Gappa's numbers don't have. [`underflow`]: what products lose where they are subnormal.
//! * [`polynomial`]: the formula is the determinant, and the permanent is its permanent.
//! * [`report`]: everything at once, in tables; also by Coq.
//!
//! `cargo xtask prove` runs it. `docs/TRUST.md` says what else is trusted.

pub mod approximations;
pub mod chain;
pub mod filters;
pub mod gappa;
pub mod linear;
mod near;
pub mod overflow;
pub mod polynomial;
pub mod report;
pub mod rules;
pub mod tolerances;
pub mod trace;
pub mod underflow;
