//! Faults planted in algorithms, to prove that the checks of their answers can fail.
//!
//! A backend with a planted fault answers questions wrongly; these are
//! algorithms that go wrong by themselves, whatever the session says. Each
//! fault is a type, and the algorithms are generic over it by constants: compiled for
//! [`Honest`], which is what users call, nothing is left of them.
//!
//! | fault | planted in | by |
//! |---|---|---|
//! | [`LostSubPair`] | [`contacts`](crate::contacts) | [`contacts_planted`](crate::contacts::contacts_planted) |
//! | [`ForgottenSubPairs`] | [`contacts`](crate::contacts) | [`contacts_planted`](crate::contacts::contacts_planted) |
//! | [`ClosedInterval`] | [`interval`](crate::interval) | [`cells_at_planted`](crate::interval::cells_at_planted) |
//! | [`SkippedEdge`] | [`polygon_locate`](crate::polygon_locate) | [`LocateIndex::planted`](crate::polygon_locate::LocateIndex::planted) |
//! | [`DroppedBorderCube`] | [`cube_union`](crate::cube_union) | [`cube_union_planted`](crate::cube_union::cube_union_planted) |

/// One way for an algorithm to be wrong, known at compile time.
///
/// A fault sets one of the constants; an algorithm looks at its own and at no others.
pub trait Planted: Sync {
    /// The name of the fault.
    const NAME: &'static str;
    /// What is wrong, in one line.
    const WHAT: &'static str;

    /// Contacts: the last registration of each level but the last is dropped.
    const LOSES_SUB_PAIRS: bool = false;
    /// Contacts: no pair has ever ended.
    const FORGETS_SUB_PAIRS: bool = false;
    /// Intervals: a point at an end is inside, of both cells that meet there.
    const CLOSES_INTERVALS: bool = false;
    /// Maps: the cells of the broad phase lack an edge.
    const SKIPS_AN_EDGE: bool = false;
    /// Cubes: one whose upper face is on the border of a cell is not looked at there.
    const DROPS_BORDER_CUBES: bool = false;
}

/// No fault.
#[derive(Clone, Copy, Debug)]
pub struct Honest;

impl Planted for Honest {
    const NAME: &'static str = "honest";
    const WHAT: &'static str = "nothing is wrong";
}

/// Contacts that lose a registration that more than ends its own pair: neither
/// reported nor remembered.
#[derive(Clone, Copy, Debug)]
pub struct LostSubPair;

impl Planted for LostSubPair {
    const NAME: &'static str = "lost-sub-pair";
    const WHAT: &'static str = "the last pair that a level below full dimension registers is lost";
    const LOSES_SUB_PAIRS: bool = true;
}

/// Contacts that ask about pairs that have ended.
///
/// With exact signs the questions themselves say no then, and nothing is
/// wrong but the counts; with a band, pairs are registered again.
#[derive(Clone, Copy, Debug)]
pub struct ForgottenSubPairs;

impl Planted for ForgottenSubPairs {
    const NAME: &'static str = "forgotten-sub-pairs";
    const WHAT: &'static str = "pairs of which a sub-pair is registered are asked about all the same";
    const FORGETS_SUB_PAIRS: bool = true;
}

/// Cells that hold both of their ends.
#[derive(Clone, Copy, Debug)]
pub struct ClosedInterval;

impl Planted for ClosedInterval {
    const NAME: &'static str = "closed-interval";
    const WHAT: &'static str = "a point at the end of a cell counts as inside";
    const CLOSES_INTERVALS: bool = true;
}

/// A map one edge of which is in no cell of the grid.
#[derive(Clone, Copy, Debug)]
pub struct SkippedEdge;

impl Planted for SkippedEdge {
    const NAME: &'static str = "skipped-edge";
    const WHAT: &'static str = "the grid skips an edge in the middle of the map";
    const SKIPS_AN_EDGE: bool = true;
}

/// Cubes that are looked at only in cells that they reach into.
#[derive(Clone, Copy, Debug)]
pub struct DroppedBorderCube;

impl Planted for DroppedBorderCube {
    const NAME: &'static str = "dropped-border-cube";
    const WHAT: &'static str = "a cube whose upper face is on the border of a cell is not looked at there";
    const DROPS_BORDER_CUBES: bool = true;
}
