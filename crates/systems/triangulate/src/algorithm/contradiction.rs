//! The invariants that the algorithm relies on.

use predicament_predicates::contradiction;

contradiction! {
    /// An invariant that the signs or the loops break.
    pub enum Contradiction {
        NoArea: "a face has area in a plane", "a face has no area in any coordinate plane";
        Hole: "a hole can be joined to a vertex on its left", "a hole cannot be joined to a vertex on its left";
        Loop: "a loop has three vertices", "a loop has fewer than three vertices";
        Ear: "a polygon has an ear", "a polygon has no ear";
        Split: "a split vertex is inside", "a split vertex is outside";
        Start: "a start vertex is outside", "a start vertex is inside";
        Chain: "a vertex sees the opposite chain", "a vertex does not see the opposite chain";
        Walk: "a walk has three vertices", "a walk has fewer than three vertices";
        Place: "the edges at a place come and leave in turn", "the edges at a place do not come and leave in turn";
        End: "the edges of an end vertex bound one region", "the edges of an end vertex bound two regions";
        Side: "the third side of an ear is a new edge", "the third side of an ear is an edge already";
        TooMany: "there are fewer than 2^30 vertices", "there are 2^30 vertices or more";
        Mesh: "walks make a mesh", "walks do not make a mesh";
    }
}
