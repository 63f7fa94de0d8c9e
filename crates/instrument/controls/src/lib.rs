//! Control backends: predicates in common use, as they are used.
//!
//! Controls are ordinary backends. They declare the same contract as `exact`, that zero means zero; all but one do not
//! guarantee it. A harness that finds no errors in them cannot find errors at all.
//!
//! * [`Naive`]: plain f64 determinants, with the pivot as a parameter.
//! * [`Epsilon`]: the same, with zero for |determinant| < ε.
//! * [`Grid`]: coordinates rounded to multiples of a step, then exact signs.
//! * [`Shewchuk`]: the crate `robust` as it is, without a guard against underflow and overflow.
//! * [`ExactRational`]: every predicate in rationals, constructed vertices included. Its answers are right; it is the
//!   control of time.
//!
//! All but the last [compute](constructed) constructed vertices in doubles when a scene is prepared or a session
//! constructs them, and from then on treat them as points with those coordinates. So the input of the first predicate
//! is already wrong. Further vertices may be constructed from them. A construction that gives no point, such as
//! parallel lines, is not refused: its coordinates are infinite or NaN. They return the determinant that they computed
//! as [`estimate`](predicament_predicates::Predicates::estimate).

mod determinant;
mod epsilon;
mod grid;
mod naive;
mod naive_session;
mod rational;
mod rounded;
mod session;
mod shewchuk;

pub use determinant::Pivot;
pub use epsilon::{BadEpsilon, Epsilon};
pub use grid::{BadStep, Grid};
pub use naive::Naive;
pub use naive_session::NaiveSession;
pub use rational::{ExactRational, RationalSession};
pub use rounded::constructed;
pub use session::Session;
pub use shewchuk::Shewchuk;
