//! The place of a probe, as the algorithm, the checks and the truth represent it.

/// The place of a point relative to a cell.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Place {
    /// The point is left or right of the cell.
    Outside,
    /// The point is at an end of the cell.
    AtEnd,
    /// The point is between the ends.
    Inside,
}

/// The cells that a probe is not outside of, ascending.
pub type Found = Vec<(usize, Place)>;
