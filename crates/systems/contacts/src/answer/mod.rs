//! What is answered about two complexes: the pairs that are registered, how each is asked about, and what is merged.
//!
//! The algorithm, the checks and the truth speak of these.

mod ask;
mod merged;
mod pairs;
mod seat;

pub use ask::ask;
pub use merged::{Arrangement, MergedPoint, Side};
pub use pairs::{Contact, Contacts, Level, Weights, levels};
pub use seat::{Seat, Stand};
