//! The exact backend: the sign of the real determinant, for every finite input.
//!
//! A query climbs a ladder until a rung can prove its answer ([`stage`]):
//!
//! 1. [`filter`]: plain floating point with a bound on its error. Where the
//!    scene's numbers are short enough, the bound is zero and the filter
//!    settles ties as well.
//! 2. [`expansion`]: the adaptive predicates of the crate `robust`.
//! 3. [`rational`]: integers over a common power of two.
//!
//! The first two hold as long as nothing underflows or overflows. Whether that
//! is so is not hoped for but proved, once per scene, by
//! [`Plan`](predicament_arithmetic::Plan), and for a scene whose exponents are
//! too wide, again for each query alone. Queries without a proof go to the
//! third rung, which needs none.
//!
//! [`Session`] also decides without tallying (`decide_…`), for backends that
//! stand on this one and count their own stages.

mod backend;
pub mod estimate;
pub mod expansion;
pub mod filter;
pub mod form;
mod ladder;
pub mod rational;
mod session;

pub use backend::{Exact, stage};
pub use session::Session;
