//! The invariants that the algorithm relies on.

use predicament_predicates::contradiction;

contradiction! {
    /// An invariant that fails because signs contradict each other.
    pub enum Contradiction {
        NoArea: "a face has an area in a coordinate plane", "a face has no area in any coordinate plane";
        Crossings: "a face has an even number of crossings", "a face has an odd number of crossings";
        ThreeEdges: "a face has three edges", "a face has fewer than three edges";
        OneSide: "a face is on one side of a plane", "a face is on both sides of a plane";
        TooMany: "a mesh has at most 2^32 - 2 elements of a kind", "a mesh has more than 2^32 - 2 elements of a kind";
        Across: "an edge across a face stays in it", "an edge across a face leaves it";
        TwoEnds: "an edge has two ends", "an edge has one vertex at both ends";
        Mesh: "the mesh keeps its invariants", "the mesh does not keep its invariants";
        Joined: "two vertices are joined by one edge at most", "two vertices are joined by two edges";
    }
    or {
        /// A face or a cap is not triangulated.
        Triangulation(predicament_triangulate::algorithm::Contradiction);
    }
}
