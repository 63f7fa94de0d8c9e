//! The check that every point is in exactly one cell of a line (Franklin & Magalhães, 4.1).

use crate::answer::Place;

/// A violation of the partition into cells.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum PartitionFault {
    /// The point is within the whole line of cells, and in no cell.
    Gap,
    /// The point is in more than one cell, or in one and at the end of another.
    Double,
    /// The point is outside of the whole line of cells, and in a cell.
    Stray,
}

impl PartitionFault {
    /// The name of the check that finds this fault.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            PartitionFault::Gap => "gap",
            PartitionFault::Double => "double",
            PartitionFault::Stray => "stray",
        }
    }
}

/// The fault of the cells that a point was found in, if any.
///
/// `whole` is the point's place relative to the cell between the first and the last end, as the same session compares
/// them. `found` are its places in the cells that it is not outside of. A judge is not needed: the cells contradict
/// their union.
///
/// A session that does not break ties may report an end where two cells meet: then the point is at the ends of all the
/// cells there (at least two) and inside none.
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
