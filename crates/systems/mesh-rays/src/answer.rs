//! The hits of a line with a mesh.
//!
//! A mesh is a set of open simplices: its vertices, its edges without their ends, and its faces without their borders.
//! A line hits a simplex if they have a common point. So a line through a vertex hits the vertex, and not the edges and
//! faces around it; a line along an edge hits the edge and its ends.

use predicament_predicates::Vertex;

/// The part of the line through the two points of a query that counts.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Extent {
    /// The whole line.
    Line,
    /// The part from the first point on, through the second one and beyond.
    Ray,
    /// The part between the two points, both included.
    Segment,
}

impl Extent {
    /// All parts.
    pub const ALL: [Extent; 3] = [Extent::Line, Extent::Ray, Extent::Segment];

    /// The name in suites.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Extent::Line => "line",
            Extent::Ray => "ray",
            Extent::Segment => "segment",
        }
    }

    /// True if the part begins at the first point.
    #[must_use]
    pub const fn has_start(self) -> bool {
        !matches!(self, Extent::Line)
    }

    /// True if the part ends at the second point.
    #[must_use]
    pub const fn has_end(self) -> bool {
        matches!(self, Extent::Segment)
    }
}

/// An open simplex of a mesh.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Feature {
    /// A vertex.
    Vertex(Vertex),
    /// An edge by its vertices, the smaller id first.
    Edge([Vertex; 2]),
    /// A triangle by its index.
    Face(u32),
}

/// A hit of a simplex.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Hit {
    /// The simplex.
    pub feature: Feature,
    /// True if the common part is an interval: the line runs along the edge, or in the plane of the face. Otherwise it
    /// is a point.
    pub is_along: bool,
}

impl std::fmt::Display for Hit {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.feature {
            Feature::Vertex(v) => write!(f, "vertex {v}")?,
            Feature::Edge([a, b]) => write!(f, "edge {a} {b}")?,
            Feature::Face(face) => write!(f, "face {face}")?,
        }
        f.write_str(if self.is_along { " along" } else { "" })
    }
}

/// The hits of one query, in groups.
///
/// The hits of a group begin at one place. Groups are in the order of these places. Points and intervals that begin at
/// one place are two groups, the points first. An interval that the query's first point cuts begins there.
pub type Groups = Vec<Vec<Hit>>;

/// The answer to one query.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Hits {
    /// The hits; in each group ascending.
    pub groups: Groups,
    /// The times that the query leaves the mesh through a face, minus the times that it enters the mesh.
    ///
    /// Ties are broken by moving the query by (ε, ε², ε³), so that it passes beside all vertices and edges. The number
    /// of a ray is the winding number of a closed mesh around its first point. `None` if an end of the query is on the
    /// mesh.
    pub crossings: Option<i64>,
}

/// The groups in words: `vertex 3, edge 1 2 and face 7`.
#[must_use]
pub fn describe(groups: &[Vec<Hit>]) -> String {
    if groups.is_empty() {
        return "nothing".to_owned();
    }
    let group = |group: &Vec<Hit>| group.iter().map(Hit::to_string).collect::<Vec<_>>().join(" and ");
    groups.iter().map(group).collect::<Vec<_>>().join(", ")
}

/// The edge of two vertices.
#[must_use]
pub fn edge(a: Vertex, b: Vertex) -> Feature {
    Feature::Edge(if b < a { [b, a] } else { [a, b] })
}

/// The edges of a triangle, in its direction.
#[must_use]
pub fn edges([a, b, c]: [Vertex; 3]) -> [[Vertex; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}
