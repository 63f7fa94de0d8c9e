//! The reasons why loops bound no polygon.

use predicament_predicates::Vertex;

/// A place where loops bound no polygon.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fault {
    /// The reason.
    pub kind: FaultKind,
    /// The vertices there: the ends of two edges, or one vertex.
    pub vertices: Vec<Vertex>,
}

/// The reasons why loops bound no polygon.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FaultKind {
    /// Two edges cross, or loops cross at a vertex.
    Cross,
    /// Two edges have a part in common, but not all of both.
    Overlap,
    /// A loop goes to a vertex and back on the same line.
    Spike,
    /// Two edges are in one place, and the inside is not on both sides of them.
    Doubled,
    /// All corners of a loop are in one place.
    Point,
}

impl Fault {
    /// The fix, in one line.
    #[must_use]
    pub fn cure(&self) -> &'static str {
        match self.kind {
            FaultKind::Cross => "divide the loops where they cross",
            FaultKind::Overlap => "divide each edge at the corners on it, then join loops along their common edges",
            FaultKind::Spike => "leave the spike out",
            FaultKind::Point => "leave the loop out",
            FaultKind::Doubled => "write a loop once, and join loops along their common edges",
        }
    }
}

/// Displays the reason and the vertices.
impl std::fmt::Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [a, b, c, d] = match &self.vertices[..] {
            [v, ..] if self.kind == FaultKind::Point => {
                return write!(f, "all corners of the loop at vertex {v} are in one place");
            }
            [a, b, c, d] => [a, b, c, d],
            [v, ..] => return write!(f, "loops cross each other at vertex {v}"),
            [] => return f.write_str("loops cross each other"),
        };
        match self.kind {
            FaultKind::Point => f.write_str("all corners of a loop are in one place"),
            FaultKind::Cross => write!(f, "the edges from {a} to {b} and from {c} to {d} cross"),
            FaultKind::Overlap => write!(f, "the edges from {a} to {b} and from {c} to {d} overlap on a line"),
            FaultKind::Spike => write!(f, "the edges from {a} to {b} and from {c} to {d} are a spike, forth and back"),
            FaultKind::Doubled => write!(
                f,
                "the edges from {a} to {b} and from {c} to {d} are in one place, and the inside is not on both sides"
            ),
        }
    }
}
