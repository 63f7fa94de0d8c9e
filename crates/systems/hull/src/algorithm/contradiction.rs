//! The invariants that the algorithm relies on.

use predicament_predicates::contradiction;

contradiction! {
    /// An invariant that does not hold, because signs contradict each other.
    pub enum Contradiction {
        Face: "a face has three vertices of three faces each", "a face has fewer than three vertices of three faces each";
        Turned: "a stitching face has the edge that it is turned about", "a stitching face lacks the edge that it is turned about";
        TwoBridges: "a stitching face has two edges between the parts", "a stitching face does not have two edges between the parts";
        Sees: "a vertex sees some faces and not all", "a vertex outside sees all faces";
        Bridge: "an edge between the parts has a face", "an edge between the parts has no face";
        Within: "an edge of a stitching face within a part is an edge of that", "an edge of a stitching face within a part is not an edge of that part";
        Loop: "faces in one plane have one loop around them", "faces in one plane do not have one loop around them";
        Outside: "no vertex is outside of a stitching face", "a vertex is outside of a stitching face";
        Closed: "stitched faces make a closed surface", "stitched faces make a surface that is not closed";
        Surface: "stitched faces make a surface", "stitched faces do not make a surface";
        Part: "the faces of a part make a surface", "the faces of a part do not make a surface";
        Horizon: "the horizon of a vertex is a single loop", "the horizon of a vertex is not a single loop";
        Convex: "the hull is convex at every edge", "the hull is not convex at an edge";
        Chains: "the lower and the upper chain meet in their ends only", "the lower and the upper chain do not meet in their ends only";
        Below: "the plane below both parts has an edge between them", "the plane below both parts has no edge between them";
        Band: "the stitching faces close to a band", "the stitching faces do not close to a band";
    }
}
