//! The invariants that the algorithm relies on.

use predicament_predicates::contradiction;

contradiction! {
    /// An invariant of arrangements that signs break.
    pub enum Contradiction {
        Component: "a component lies in a face of one that begins left of it", "a component lies in a face of none that begins left of it";
        Crossing: "a crossing is on both its segments", "a crossing is not on both its segments";
        Outer: "a region has one outer loop", "a region does not have one outer loop";
        Begins: "a segment begins once", "a segment begins twice";
        Ends: "an edge ends after it begins", "an edge ends before it begins";
        Events: "events come from left to right", "an event comes left of the one before";
        Windings: "winding numbers agree around every edge", "winding numbers do not agree around an edge";
    }
}
