//! Do the tolerance paper's algorithms keep their guarantee at their thresholds?
//!
//! What a scheme of tolerances promises it promises at distances that random
//! scenes never have. So pairs are made at the thresholds
//! ([`ThresholdPairs`]), each is asked about
//! as the hierarchy would, its sub-pairs first, and each answer is judged by
//! exact distances ([`Bands::judge`](predicament_checks::audit::Bands::judge)).
//!
//! * [`Audit`]: the study.
//! * [`Row`]: which algorithm, in which precision, over which form of
//!   Algorithms 3 and 8; [`rows`]: all there are.
//! * [`Scheme`]: the algorithms of one L, asked about lists of points.
//! * [`audit()`]: a stream of pairs through one row; [`Tally`]: its counts.

mod row;
mod scheme;
mod stream;
mod study;
mod table;
mod tally;
mod thresholds;

pub use row::{Algorithm, Form, Row, rows};
pub use scheme::Scheme;
pub use stream::audit;
pub use study::{Audit, Audited};
pub use tally::{NEAR, Tally, Violation};
pub use thresholds::{ThresholdPairs, Thresholds};
