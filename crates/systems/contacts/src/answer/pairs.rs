//! Registered pairs of simplices.

use predicament_mesh::Simplex;
use predicament_predicates::Dimension;

/// Barycentric coordinates of a point in a simplex, one for each of its
/// vertices in ascending order; those that the simplex lacks are zero.
pub type Weights = [f64; 4];

/// A registered pair: a simplex of each complex, and where on it they meet.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Contact {
    /// The simplex of the first complex.
    pub a: Simplex,
    /// The simplex of the second complex.
    pub b: Simplex,
    /// Where on the first.
    pub on_a: Weights,
    /// Where on the second.
    pub on_b: Weights,
}

/// Counts of the pairs of two ranks: candidates, ended, asked, registered.
///
/// Every candidate either had ended or was asked about.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Level {
    /// The ranks of the simplices of the first and of the second complex.
    pub ranks: [u8; 2],
    /// Pairs whose boxes are within the session's reach of each other.
    pub candidates: u64,
    /// Those that had ended: a sub-pair was registered.
    pub ended: u64,
    /// Those that the session was asked about.
    pub asked: u64,
    /// Those that it registered.
    pub registered: u64,
}

/// All registered pairs, and how many there were to look at.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Contacts {
    /// The registered pairs, by level (the sum of the ranks), then by simplices.
    pub registered: Vec<Contact>,
    /// Counts of the pairs, in the order of [`levels`].
    pub levels: Vec<Level>,
}

/// The ranks of the pairs of each level, level after level.
#[must_use]
pub fn levels(dimension: Dimension) -> &'static [&'static [[u8; 2]]] {
    const LEVELS: [&[[u8; 2]]; 4] =
        [&[[0, 0]], &[[0, 1], [1, 0]], &[[0, 2], [1, 1], [2, 0]], &[[0, 3], [1, 2], [2, 1], [3, 0]]];
    &LEVELS[..=dimension.count()]
}
