//! The cover of a loop: triangles on the loop's own vertices, or the reason why there is no cover.
//!
//! A loop is a list of vertices in a cycle. A cover has an edge along each edge of the loop, in the loop's direction.
//! The loop of a hole runs against the triangles around the hole, so a cover continues the mesh's orientation.

use predicament_predicates::Vertex;

/// The reason why a loop is not covered.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Reason {
    /// The loop passes a vertex twice.
    Repeats,
    /// All covers were excluded: each has a triangle without area, an edge that is in use, or a crossing.
    Crosses,
    /// The search ended at its work limit, without a cover.
    Search,
}

impl Reason {
    /// All reasons.
    pub const ALL: [Reason; 3] = [Reason::Repeats, Reason::Crosses, Reason::Search];

    /// The name in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Reason::Repeats => "the loop passes a vertex twice",
            Reason::Crosses => "every cover crosses itself or the mesh",
            Reason::Search => "the search ended at its work limit",
        }
    }
}

/// The answer about one loop.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Cover {
    /// The triangles, ascending by the places of their corners on the loop.
    Triangles(Vec<[Vertex; 3]>),
    /// The loop is not covered.
    Uncovered(Reason),
}

impl std::fmt::Display for Cover {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Cover::Triangles(all) => {
                let told: Vec<String> = all.iter().map(|[a, b, c]| format!("{a} {b} {c}")).collect();
                write!(f, "triangles {}", told.join(", "))
            }
            Cover::Uncovered(reason) => write!(f, "uncovered: {}", reason.name()),
        }
    }
}

/// The edges of a cycle of vertices, in its direction.
pub fn edges(around: &[Vertex]) -> impl Iterator<Item = [Vertex; 2]> + '_ {
    around.iter().zip(around.iter().cycle().skip(1)).map(|(&a, &b)| [a, b])
}

/// The ends of an edge, ascending.
#[must_use]
pub fn undirected([a, b]: [Vertex; 2]) -> [Vertex; 2] {
    [a.min(b), a.max(b)]
}
