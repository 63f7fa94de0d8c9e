//! A cube, and where it is in a range of points.

/// A box of points from the first to before the second coordinate, for each axis.
pub(super) type Range = [[i64; 2]; 3];

/// Whether the cube reaches the cell: a face of it may be on the lower border.
#[inline]
pub(super) fn reaches(lower: [i64; 3], edge: i64, cell: Range) -> bool {
    (0..3).all(|axis| lower[axis] < cell[axis][1] && lower[axis] + edge >= cell[axis][0])
}

/// The face of a cube in a range: none, or whether it is the upper one. In a
/// range no wider than the cube there is at most one.
#[inline]
pub(super) fn face_in(lower: i64, edge: i64, [from, to]: [i64; 2]) -> Option<bool> {
    let is_in = |at: i64| from <= at && at < to;
    if is_in(lower) {
        Some(false)
    } else if is_in(lower + edge) {
        Some(true)
    } else {
        None
    }
}

/// A cube that reaches a cell.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cube {
    /// The lower corner, from the grid's.
    pub(super) lower: [i64; 3],
    /// The place in the input.
    pub(super) index: u32,
}
