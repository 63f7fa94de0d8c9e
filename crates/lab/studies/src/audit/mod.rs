//! Do the tolerance paper's algorithms keep their guarantee at their thresholds?
//!
//! What a scheme of tolerances promises it promises at distances that random
//! scenes never have. So pairs are made at the thresholds
//! ([`ThresholdPairs`]), each is asked about
//! as the hierarchy would, its sub-pairs first, and each answer is judged by
//! exact distances ([`Bands::judge`](predicament_contacts::checks::audit::Bands::judge)).
//!
//! The hierarchy leaves most tests no choice, so each is asked about by itself as well,
//! with pairs at its own tolerance ([`read()`]). And the driver that goes through the
//! levels is held to the same guarantee, on scenes of one pair ([`hierarchy()`]).
//!
//! All of it is held to the published tolerances, not to those of the code under audit. The
//! numbers of that are held to the published ones besides ([`constants()`]): one that is off can hide
//! behind another test.
//!
//! * [`Audit`]: the study.
//! * [`Row`]: which algorithm, in which precision, over which form of
//!   Algorithms 3 and 8; [`rows`]: all there are.
//! * [`Scheme`]: the algorithms of one L, asked about lists of points.
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
