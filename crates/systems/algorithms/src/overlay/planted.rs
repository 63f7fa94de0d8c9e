//! Faults planted in overlays. See [`crate::planted`].

use crate::planted::{Fault, Honest, fault};

/// What can be wrong here. A fault sets one of the constants.
pub trait Planted: Fault {
    /// Segments whose boxes only touch are not compared.
    const BOXES_ARE_OPEN: bool = false;
    /// A vertex on another segment is not put on it.
    const FORGETS_TOUCHES: bool = false;
    /// Vertices on a segment stay in the order of their ids.
    const LEAVES_UNSORTED: bool = false;
    /// Edges of several input edges count as one.
    const COUNTS_ONCE: bool = false;
    /// Components that are in a face of another one are taken to be outside of all.
    const NESTS_OUTSIDE: bool = false;
    /// The holes of results are left out.
    const DROPS_HOLES: bool = false;
}

impl Planted for Honest {}

fault!(
    OpenBoxes,
    "A broad phase that is strict where it has to be closed.",
    "open-boxes",
    "segments whose boxes only touch are not compared",
    BOXES_ARE_OPEN
);
fault!(
    ForgottenTouches,
    "Touching vertices that divide nothing.",
    "forgotten-touches",
    "a vertex on another segment does not divide it",
    FORGETS_TOUCHES
);
fault!(
    UnsortedChains,
    "Chains in the order of ids.",
    "unsorted-chains",
    "the vertices on a segment are in the order of their ids",
    LEAVES_UNSORTED
);
fault!(
    SingleCounts,
    "Winding numbers that do not count.",
    "single-counts",
    "edges that several input edges pass are counted once",
    COUNTS_ONCE
);
fault!(
    OutsideNests,
    "Components that are not in the faces around them.",
    "outside-nests",
    "components in a face of another are taken to be outside",
    NESTS_OUTSIDE
);
fault!(DroppedHoles, "Results without holes.", "dropped-holes", "the holes of results are left out", DROPS_HOLES);
