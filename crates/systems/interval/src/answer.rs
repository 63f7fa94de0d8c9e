//! Where a probe is: what the algorithm, the checks and the truth speak of.

/// Where a point is, seen from a cell.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Place {
    /// Left or right of it.
    Outside,
    /// As far along the line as one of the ends, and not outside.
    AtEnd,
    /// Between the ends.
    Inside,
}

/// The cells that a probe is not outside of, ascending.
pub type Found = Vec<(usize, Place)>;
