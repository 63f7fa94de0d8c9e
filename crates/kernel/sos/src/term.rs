//! One monomial of a perturbed determinant, as data.
//!
//! Every predicate is the determinant of a matrix with one row per vertex: its coordinates, for lifted
//! predicates (circles and spheres) their sum of squares, and a 1. Perturbed, it becomes a polynomial in
//! infinitesimals. The coefficient of a monomial is a smaller determinant of the same kind, times at most one
//! difference of coordinates; a [`Term`] describes it.

use predicament_predicates::Sign;

/// The coefficient of one monomial: `sign` × `gap` × the determinant of the remaining matrix.
///
/// Rows are numbered by the *sorted* place of the vertex, so row 0 is the vertex with the smallest index. Columns are
/// numbered by the coordinate in ascending order of axes.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Term {
    /// The sign factor.
    pub sign: Sign,
    /// An optional factor, a difference of two coordinates.
    pub gap: Option<Gap>,
    /// The remaining rows, ascending: one more than columns and lift together.
    pub rows: &'static [u8],
    /// The remaining coordinate columns, ascending.
    pub columns: &'static [u8],
    /// The lift column, if it remains.
    pub lift: Option<Lift>,
}

/// The difference of two coordinates: `column` of row `from` minus that of row `to`.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Gap {
    /// The index of the coordinate.
    pub column: u8,
    /// The row whose coordinate counts positive.
    pub from: u8,
    /// The row whose coordinate is subtracted.
    pub to: u8,
}

/// The content of the lift column: Σ over the coordinates c of (x_c − o_c)².
///
/// The origin's coordinate o_c is 0, or the coordinate c of the row `about[c]`. If a vertex really moves along c, its
/// lift moves with it, and the coefficient is a determinant lifted about that vertex.
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

    /// The same term with a lift column.
    #[must_use]
    pub const fn lifted(self, about: [Option<u8>; 3]) -> Term {
        Term { lift: Some(Lift { about }), ..self }
    }

    /// The same term times a difference of coordinates.
    #[must_use]
    pub const fn times(self, gap: Gap) -> Term {
        Term { gap: Some(gap), ..self }
    }
}
