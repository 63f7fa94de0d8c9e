//! The invariants that rounding relies on.

use predicament_predicates::contradiction;

contradiction! {
    /// An invariant that signs break before chains are made.
    pub enum Contradiction {
        Segments: "an arrangement has the segments that were given", "an arrangement does not have the segments that were given";
        NoPoint: "segments that cross have a point in common", "segments that cross have no point in common";
    }
    or {
        /// The arrangement contradicts itself.
        Arrangement(crate::algorithm::overlay::Contradiction);
    }
}
