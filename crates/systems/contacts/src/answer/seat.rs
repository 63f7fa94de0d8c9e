//! The location of a merged point.

use predicament_mesh::Simplex;
use predicament_predicates::Vertex;

use super::{MergedPoint, Side, Weights};

/// The rule for the location of a merged point.
///
/// The registrations do not determine the location. Cutting a mesh usually keeps the mesh and bends the cutting
/// surface, or the other way round. For each complex a point has at most one [`Stand`]. A point with a stand in only
/// one complex is there under every rule.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Seat {
    /// The first complex stays, the second moves to it.
    A,
    /// The second complex stays, the first moves to it.
    B,
    /// The point half way between the two complexes.
    Middle,
}

impl Seat {
    /// All three rules.
    pub const ALL: [Seat; 3] = [Seat::A, Seat::B, Seat::Middle];

    /// The rule's name in files and reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Seat::A => "a",
            Seat::B => "b",
            Seat::Middle => "middle",
        }
    }
}

impl std::fmt::Display for Seat {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(self.name())
    }
}

/// The location of a merged point on one complex.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Stand {
    /// At this vertex.
    Vertex(Vertex),
    /// Between the vertices of this simplex, at their own points' locations on the same complex.
    Inside(Simplex, Weights),
}

impl MergedPoint {
    /// The location of the point on a complex, if it is there: at its lowest vertex, otherwise inside the first simplex
    /// that it was registered in.
    #[must_use]
    pub fn stand(&self, side: Side) -> Option<Stand> {
        let vertex = self.vertices[side as usize].first().map(|&vertex| Stand::Vertex(vertex));
        let inside = || self.inside[side as usize].first().map(|&(simplex, weights)| Stand::Inside(simplex, weights));
        vertex.or_else(inside)
    }
}
