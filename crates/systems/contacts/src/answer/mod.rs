//! The answers about two complexes: the registered pairs, the query for each, and the merged complexes.
//!
//! The algorithm, the checks and the truth share these types.

mod ask;
mod merged;
mod pairs;
mod seat;

pub use ask::ask;
pub use merged::{Arrangement, MergedPoint, Side};
pub use pairs::{Contact, Contacts, Level, Weights, levels};
pub use seat::{Seat, Stand};
