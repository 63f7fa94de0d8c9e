//! Faults planted in Delaunay triangulations. See [`crate::planted`].

use crate::planted::{Fault, Honest, fault};

/// What can be wrong here. A fault sets one of the constants.
pub trait Planted: Fault {
    /// Of the triangles whose circle a vertex is in, only neighbours of the first one are replaced.
    const LOOKS_AT_NEIGHBOURS_ONLY: bool = false;
    /// A vertex outside of the hull is joined to the edge by which it was found, and to no other.
    const SEES_ONE_EDGE: bool = false;
    /// A vertex in the line of an edge of the hull is taken for one outside of it.
    const TAKES_LINES_FOR_OUTSIDE: bool = false;
    /// Faces of more than three vertices on a circle stay cut as they are.
    const LEAVES_FACES: bool = false;
    /// Repeated vertices are not listed.
    const FORGETS_COPIES: bool = false;
    /// A constraint that goes through a vertex ends there.
    const STOPS_AT_VERTICES: bool = false;
}

impl Planted for Honest {}

fault!(
    NeighboursOnly,
    "Triangles that stay though a vertex is in their circle.",
    "delaunay-neighbours-only",
    "of the triangles whose circle a vertex is in, only neighbours of the first one are replaced",
    LOOKS_AT_NEIGHBOURS_ONLY
);
fault!(
    OneEdgeSeen,
    "A hull with dents.",
    "delaunay-one-edge-seen",
    "a vertex outside of the hull is joined to one edge of it only",
    SEES_ONE_EDGE
);
fault!(
    LinesOutside,
    "Flat triangles beside the hull.",
    "delaunay-lines-outside",
    "a vertex in the line of an edge of the hull is joined to that edge",
    TAKES_LINES_FOR_OUTSIDE
);
fault!(
    FacesLeft,
    "Faces of vertices on one circle, cut as insertion left them.",
    "delaunay-faces-left",
    "faces of vertices on one circle are not cut as fans from their smallest index",
    LEAVES_FACES
);
fault!(
    CopiesForgotten,
    "Repeated vertices that are nowhere.",
    "delaunay-copies-forgotten",
    "vertices in the place of another one are not listed",
    FORGETS_COPIES
);
fault!(
    StoppedConstraint,
    "Constraints that end too early.",
    "delaunay-constraint-stopped",
    "a constraint that goes through a vertex ends there",
    STOPS_AT_VERTICES
);
