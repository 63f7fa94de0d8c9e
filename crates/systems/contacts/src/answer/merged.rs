//! Two complexes, merged at their contacts.

use predicament_mesh::Simplex;
use predicament_predicates::Vertex;

use super::Weights;

/// One of the two complexes of a contact set.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Side {
    /// The first complex.
    A,
    /// The second complex.
    B,
}

impl Side {
    /// Both sides, in order.
    pub const BOTH: [Side; 2] = [Side::A, Side::B];

    /// The other side.
    #[must_use]
    pub const fn other(self) -> Side {
        match self {
            Side::A => Side::B,
            Side::B => Side::A,
        }
    }
}

impl std::fmt::Display for Side {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(match self {
            Side::A => "A",
            Side::B => "B",
        })
    }
}

/// A point of the arrangement, and the simplices that were merged into it.
///
/// The arrays have an entry for each [`Side`].
#[derive(Clone, PartialEq, Default, Debug)]
pub struct MergedPoint {
    /// The vertices of each complex, ascending; a new point has none.
    pub vertices: [Vec<Vertex>; 2],
    /// The edges, triangles and tetrahedra of each complex that pass through the point, each with its registered
    /// position; lower dimensions first.
    pub inside: [Vec<(Simplex, Weights)>; 2],
}

impl MergedPoint {
    /// True if the point has no vertex: two simplices cross between their ends.
    #[must_use]
    pub fn is_new(&self) -> bool {
        self.vertices.iter().all(Vec::is_empty)
    }

    /// True if simplices of both complexes are merged in the point.
    #[must_use]
    pub fn is_shared(&self) -> bool {
        (0..2).all(|side| !self.vertices[side].is_empty() || !self.inside[side].is_empty())
    }
}

/// The arrangement of two merged complexes.
#[derive(Clone, PartialEq, Debug)]
pub struct Arrangement {
    pub(crate) points: Vec<MergedPoint>,
    pub(crate) vertices: [Vec<usize>; 2],
    pub(crate) registrations: Vec<usize>,
    pub(crate) paths: [Vec<Vec<usize>>; 2],
}

impl Arrangement {
    /// All points: first those with vertices, by the first vertex of A or else of B; then the new ones, in the order of
    /// the contacts.
    #[must_use]
    pub fn points(&self) -> &[MergedPoint] {
        &self.points
    }

    /// The point of a vertex, as an index in [`Arrangement::points`]. The vertex is given by its index in its complex.
    ///
    /// # Panics
    /// If the complex does not have the vertex.
    #[must_use]
    pub fn of_vertex(&self, side: Side, index: u32) -> usize {
        self.vertices[side as usize][index as usize]
    }

    /// The point of each contact, in the order of the contacts.
    #[must_use]
    pub fn of_contacts(&self) -> &[usize] {
        &self.registrations
    }

    /// The points that an edge passes through, from its lower vertex to the higher.
    ///
    /// Points registered between the ends are in the order of their positions and then of their indices, without
    /// consecutive repetitions. The position of a vertex exactly on the edge's line is exact; other positions are
    /// weights. Of points at one double, exact vertices come first. The path of a collapsed edge is one point.
    ///
    /// # Panics
    /// If the complex does not have the edge.
    #[must_use]
    pub fn path(&self, side: Side, edge: u32) -> &[usize] {
        &self.paths[side as usize][edge as usize]
    }
}
