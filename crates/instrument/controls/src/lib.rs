//! Backends to compare with: predicates in common use, as they are used.
//!
//! Controls are ordinary backends. They declare the same contract as `exact`, that
//! zero means zero, without guaranteeing it: a harness that finds no errors in them
//! finds none at all.
//!
//! * [`Naive`]: plain f64 determinants, the pivot a parameter.
//! * [`Epsilon`]: the same, with |determinant| < ε taken for zero.
//! * [`Shewchuk`]: the crate `robust` as it is, without a guard against
//!   underflow and overflow.
//!
//! Constructed vertices are [computed](constructed) in doubles when a scene is
//! prepared or a session constructs them, and taken for points with those
//! coordinates from then on: that is wrong before the first predicate is asked.
//! Others may be constructed from those; a definition of no point, such as
//! parallel lines, is not refused: its coordinates are infinite or NaN.
//!
//! Each keeps the determinant it computed for
//! [`estimate`](predicament_predicates::Predicates::estimate).

mod determinant;
mod epsilon;
mod naive;
mod naive_session;
mod rounded;
mod session;
mod shewchuk;

pub use determinant::Pivot;
pub use epsilon::{BadEpsilon, Epsilon};
pub use naive::Naive;
pub use naive_session::NaiveSession;
pub use rounded::constructed;
pub use session::Session;
pub use shewchuk::Shewchuk;
