//! Registered pairs of simplices.

use predicament_mesh::Simplex;
use predicament_predicates::Dimension;

/// Barycentric coordinates of a point in a simplex, one for each vertex in ascending order; unused entries are zero.
pub type Weights = [f64; 4];

/// A registered pair: a simplex of each complex, and the position of the contact on both.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Contact {
    /// The simplex of the first complex.
    pub a: Simplex,
    /// The simplex of the second complex.
    pub b: Simplex,
    /// The position on the first simplex.
    pub on_a: Weights,
    /// The position on the second simplex.
    pub on_b: Weights,
}

/// The numbers of pairs of two ranks: candidates, ended, asked, registered.
///
/// Every candidate either had ended or was queried.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Level {
    /// The ranks of the simplices of the first and of the second complex.
    pub ranks: [u8; 2],
    /// Pairs whose boxes are within the session's reach of each other.
    pub candidates: u64,
    /// Candidates that had ended: a sub-pair was registered.
    pub ended: u64,
    /// Candidates on which the session was queried.
    pub asked: u64,
    /// Pairs that the session registered.
    pub registered: u64,
}

/// All registered pairs, and the numbers of tested pairs.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Contacts {
    /// The registered pairs, by level (the sum of the ranks), then by simplices.
    pub registered: Vec<Contact>,
    /// The numbers of pairs, in the order of [`levels`].
    pub levels: Vec<Level>,
}

/// The ranks of the pairs of each level, level after level.
#[must_use]
pub fn levels(dimension: Dimension) -> &'static [&'static [[u8; 2]]] {
    const LEVELS: [&[[u8; 2]]; 4] =
        [&[[0, 0]], &[[0, 1], [1, 0]], &[[0, 2], [1, 1], [2, 0]], &[[0, 3], [1, 2], [2, 1], [3, 0]]];
    &LEVELS[..=dimension.count()]
}
