//! Two complexes merged where they are in contact.

use predicament_mesh::Simplex;
use predicament_predicates::Vertex;

use super::Weights;

/// One of the two complexes of a contact set.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Side {
    /// The first.
    A,
    /// The second.
    B,
}

impl Side {
    /// Both, in order.
    pub const BOTH: [Side; 2] = [Side::A, Side::B];

    /// The other one.
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

/// A point of the arrangement and everything that was merged into it.
///
/// The arrays have an entry for each [`Side`].
#[derive(Clone, PartialEq, Default, Debug)]
pub struct MergedPoint {
    /// The vertices of each complex, ascending. None at all for a new point.
    pub vertices: [Vec<Vertex>; 2],
    /// The edges, triangles and tetrahedra of each complex that pass through
    /// it, and where on them it was registered; lower dimensions first.
    pub inside: [Vec<(Simplex, Weights)>; 2],
}

impl MergedPoint {
    /// Whether no vertex is here: two simplices cross between their ends.
    #[must_use]
    pub fn is_new(&self) -> bool {
        self.vertices.iter().all(Vec::is_empty)
    }

    /// Whether something of both complexes is here.
    #[must_use]
    pub fn is_shared(&self) -> bool {
        (0..2).all(|side| !self.vertices[side].is_empty() || !self.inside[side].is_empty())
    }
}

/// Two complexes, merged.
#[derive(Clone, PartialEq, Debug)]
pub struct Arrangement {
    pub(crate) points: Vec<MergedPoint>,
    pub(crate) vertices: [Vec<usize>; 2],
    pub(crate) registrations: Vec<usize>,
    pub(crate) paths: [Vec<Vec<usize>>; 2],
}

impl Arrangement {
    /// All points: first those with vertices, by the first vertex of A or else
    /// of B; then the new ones, in the order of the contacts.
    #[must_use]
    pub fn points(&self) -> &[MergedPoint] {
        &self.points
    }

    /// The point that a vertex became: its place in [`Arrangement::points`].
    /// The vertex is given by its place in its complex.
    ///
    /// # Panics
    /// If the complex has no such vertex.
    #[must_use]
    pub fn of_vertex(&self, side: Side, index: u32) -> usize {
        self.vertices[side as usize][index as usize]
    }

    /// The point of each contact, in their order.
    #[must_use]
    pub fn of_contacts(&self) -> &[usize] {
        &self.registrations
    }

    /// The points that an edge passes through: from its lower vertex to the
    /// higher, what was registered on it between them, by place and then by
    /// point, never one twice at once. The place of a vertex that is exactly on
    /// the edge's line is exact, that of all else is its weight; what has one
    /// double for a place begins with exact vertices. The path of an edge that
    /// collapsed is one point.
    ///
    /// # Panics
    /// If the complex has no such edge.
    #[must_use]
    pub fn path(&self, side: Side, edge: u32) -> &[usize] {
        &self.paths[side as usize][edge as usize]
    }
}
