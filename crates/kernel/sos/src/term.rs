//! One monomial of a perturbed determinant, as data.
//!
//! Every predicate is the determinant of a matrix with one row a vertex: its
//! coordinates, for `incircle` and `insphere` their sum of squares (the lift),
//! and a 1. Perturbed, it becomes a polynomial in infinitesimals. The
//! coefficient of a monomial is a smaller determinant of the same kind, times
//! at most one difference of coordinates; a [`Term`] says which.

use predicament_predicates::Sign;

/// The coefficient of one monomial:
/// `sign` × `gap` × the determinant of what is left of the matrix.
///
/// Rows are numbered by the *sorted* place of the vertex, so row 0 is the
/// vertex with the smallest index. Columns are numbered by the coordinate in
/// ascending order of axes.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Term {
    /// The sign in front.
    pub sign: Sign,
    /// A factor in front.
    pub gap: Option<Gap>,
    /// The rows that are left, ascending: one more than columns and lift together.
    pub rows: &'static [u8],
    /// The coordinate columns that are left, ascending.
    pub columns: &'static [u8],
    /// The lift, where it is left.
    pub lift: Option<Lift>,
}

/// The difference of two coordinates: `column` of row `from` minus that of row `to`.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Gap {
    /// Which coordinate.
    pub column: u8,
    /// The row whose coordinate counts positive.
    pub from: u8,
    /// The row whose coordinate is subtracted.
    pub to: u8,
}

/// What the lift column holds: Σ over the coordinates c of (x_c − o_c)².
///
/// The origin's coordinate o_c is 0, or the coordinate c of the row `about[c]`.
/// When a vertex really moves along c, its lift moves with it, and the
/// coefficient is a determinant lifted about that vertex.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Lift {
    /// The row that gives the origin's coordinate, by column.
    pub about: [Option<u8>; 3],
}

impl Term {
    /// A minor without a lift; a constant if `columns` is empty.
    #[must_use]
    pub const fn minor(sign: Sign, rows: &'static [u8], columns: &'static [u8]) -> Term {
        Term { sign, gap: None, rows, columns, lift: None }
    }

    /// The same with a lift column.
    #[must_use]
    pub const fn lifted(self, about: [Option<u8>; 3]) -> Term {
        Term { lift: Some(Lift { about }), ..self }
    }

    /// The same times a difference of coordinates.
    #[must_use]
    pub const fn times(self, gap: Gap) -> Term {
        Term { gap: Some(gap), ..self }
    }
}
