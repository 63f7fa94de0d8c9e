//! The audit of the tolerance paper's algorithms: whether they keep their guarantee at their thresholds.
//!
//! A tolerance scheme makes its promise at distances that random scenes never have. So the study makes pairs at the
//! thresholds ([`ThresholdPairs`]). It queries each as the hierarchy would, its sub-pairs first, and judges each answer
//! by exact distances ([`Bands::judge`](predicament_contacts::checks::audit::Bands::judge)).
//!
//! The hierarchy leaves most tests no choice, so the study also queries each test alone, with pairs at its own
//! tolerance ([`read()`]). The driver that goes through the levels must keep the same guarantee, on scenes of one pair
//! ([`hierarchy()`]).
//!
//! All checks use the published tolerances, not the tolerances of the code under audit. The constants of that code are
//! compared with the published ones as well ([`constants()`]), because a wrong one can be hidden by another test.
//!
//! * [`Audit`]: the study.
//! * [`Row`]: an algorithm, a precision, and a form of Algorithms 3 and 8; [`rows`]: all rows.
//! * [`Scheme`]: the algorithms of one L, on lists of points.
//! * [`audit()`]: a stream of pairs through one row; [`Tally`]: its counts.

mod constants;
mod hierarchy;
mod measured;
mod reads;
mod records;
mod row;
mod scheme;
mod stream;
mod study;
mod table;
mod tally;
mod thresholds;

pub use constants::{Constant, NEAR_CONSTANT, constants};
pub use hierarchy::{Driver, Hierarchy, hierarchy};
pub use measured::{Audit, Audited};
pub use reads::{NEAR_LIMIT, Reads, read};
pub use row::{Algorithm, Form, Row, rows};
pub use scheme::Scheme;
pub use stream::{audit, exactly};
pub use tally::{NEAR, Tally, Violation};
pub use thresholds::{ThresholdPairs, Thresholds};
