//! Cells of a line: every point is in exactly one of them (Franklin & Magalhães, 4.1).

use crate::answer::Place;

/// How cells fail to be a partition.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum PartitionFault {
    /// The point is within the line's cells as a whole, and in none.
    Gap,
    /// The point is in more than one, or in one and at the end of another.
    Double,
    /// The point is outside of all cells as a whole, and in one.
    Stray,
}

impl PartitionFault {
    /// The name of the check that finds it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            PartitionFault::Gap => "gap",
            PartitionFault::Double => "double",
            PartitionFault::Stray => "stray",
        }
    }
}

/// What is wrong with the cells that a point was found in, if anything.
///
/// `whole` is where it is seen from the cell between the first and the last
/// end, as the same session compares them; `found` are the cells that it is not
/// outside of. No judge is needed: the cells contradict their union.
///
/// At an end where two cells meet, a session that breaks no ties may say so: then the
/// point is at the ends of all the cells there (of two at least) and inside none.
pub fn partition_fault(whole: Place, found: impl IntoIterator<Item = Place>) -> Option<PartitionFault> {
    let [mut inside, mut ends] = [0, 0];
    for place in found {
        match place {
            Place::Inside => inside += 1,
            Place::AtEnd => ends += 1,
            Place::Outside => {}
        }
    }
    match (whole, inside, ends) {
        (Place::Outside, 0, 0) | (Place::AtEnd, 0, 1..) | (Place::Inside, 1, 0) | (Place::Inside, 0, 2..) => None,
        (Place::Outside, _, _) => Some(PartitionFault::Stray),
        (Place::AtEnd | Place::Inside, 0, 0) => Some(PartitionFault::Gap),
        (Place::AtEnd | Place::Inside, _, _) => Some(PartitionFault::Double),
    }
}
