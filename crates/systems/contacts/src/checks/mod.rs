//! Checks of contacts.
//!
//! * [`pairs`]: registered pairs, and the curves and surfaces that they merge.
//! * [`audit`]: contacts, compared with exact distances.

pub mod audit;
pub mod pairs;
