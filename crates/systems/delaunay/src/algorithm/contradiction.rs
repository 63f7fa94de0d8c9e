//! The invariants that the algorithm relies on.

use predicament_predicates::contradiction;

contradiction! {
    /// An invariant that does not hold, because signs contradict each other.
    pub enum Contradiction {
        Crosses: "a constraint crosses a triangle once and stays in the hull", "a constraint crosses a triangle twice or leaves the hull";
        Leaves: "a constraint leaves its end through an edge or a vertex", "a constraint leaves its end through no edge and no vertex";
        Corner: "a vertex on two sides of a triangle is in the place of their corner", "a vertex is on two sides of a triangle, but not in the place of their corner";
        Missing: "a vertex that is removed is in the triangulation", "a vertex that is to be removed is not in the triangulation";
        Walk: "a walk toward a vertex ends", "a walk toward a vertex does not end";
        Apex: "an edge of a hole has a vertex on its inner side", "an edge of a hole has no vertex on its inner side";
        Disc: "the triangles that a vertex replaces are a disc", "the triangles that a vertex replaces are not a disc";
        Face: "the vertices of a face are on its boundary", "a vertex of a face is not on its boundary";
        Hull: "two hulls beside each other have common tangents", "two hulls beside each other have no common tangent";
        Flips: "flips of edges end", "flips of edges do not end";
        Once: "two constraints cross in one point", "two constraints do not cross in one point";
    }
}
