//! A cube, and its position relative to a range of points.

/// A box of points: for each axis, from the first coordinate to before the second.
pub(super) type Range = [[i64; 2]; 3];

/// True if the cube reaches the cell: a face of it may be on the lower border.
#[inline]
pub(super) fn reaches(lower: [i64; 3], edge: i64, cell: Range) -> bool {
    (0..3).all(|axis| lower[axis] < cell[axis][1] && lower[axis] + edge >= cell[axis][0])
}

/// The face of a cube in a range: `None`, or true for the upper face. A range no wider than the cube contains at most
/// one face.
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
    /// The lower corner, relative to the grid's.
    pub(super) lower: [i64; 3],
    /// The index in the input.
    pub(super) index: u32,
}
