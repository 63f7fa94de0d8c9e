//! The tolerance paper's algorithms one by one, held to their guarantee.
//!
//! What a scheme of tolerances promises it promises at distances that random
//! scenes never have. So pairs are made at the thresholds
//! ([`ThresholdPairs`](predicament_corpus::ThresholdPairs)), each is asked about
//! as the hierarchy would, its sub-pairs first, and each answer is judged by
//! exact distances ([`Bands::judge`](predicament_checks::audit::Bands::judge)).
//!
//! * [`Row`]: which algorithm, in which precision, over which form of
//!   Algorithms 3 and 8; [`rows`]: all there are.
//! * [`Scheme`]: the algorithms of one L, asked about lists of points.
//! * [`audit`]: a stream of pairs through one row; [`Tally`]: what came of it.

mod row;
mod scheme;
mod stream;
mod tally;

pub use row::{Algorithm, Form, Precision, Row, rows};
pub use scheme::Scheme;
pub use stream::audit;
pub use tally::{NEAR, Tally, Violation};
