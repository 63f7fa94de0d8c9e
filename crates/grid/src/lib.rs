//! Broad phases: which features can matter to a question, from raw
//! coordinates alone, so that the predicates are asked about few.
//!
//! A broad phase may keep too much and must never drop what matters. The ones
//! here go further: what they yield is stated in terms of the raw coordinates,
//! without reference to cells, so an answer can't depend on how the space was
//! cut.

mod columns;

pub use columns::Columns;
