//! Checks of arrangements of segments and results of Boolean operations, decided in rationals.
//!
//! The checks do not know how these were made: they get points, and indices of points. Each [`Check`] is a law.
//! Together the laws say that an arrangement is one of *all* its segments, that its faces are faces, and that results
//! contain the right points.
//!
//! # What broken ties change
//! In a scene that is perturbed by infinitesimals nothing touches. Seen in the original scene, edges may then touch and
//! overlap, faces may have no area, and nodes may be at one position. But no two edges cross, areas are unchanged, and
//! points off all edges are inside or outside as before. [`Expected::has_areas`] selects the version of the laws.

mod graph;
mod operations;
mod plane;
mod regions;
mod windings;

pub use graph::Graph;
pub use operations::{Operands, Results};
pub use plane::Point;
pub(in crate::checks) use plane::{distance, side};
pub use regions::{Defects, Shape, winding_of};
pub use windings::Windings;

/// The requirements for arrangements and results, and the sample sizes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Expected {
    /// True if nothing was perturbed: nodes are at different positions, and faces have areas.
    pub has_areas: bool,
    /// The maximum number of edges that are compared with those near them; they are spread evenly.
    pub edges_crossed: usize,
    /// The number of components whose faces are checked, and of points located.
    pub located: usize,
}

/// A law that arrangements and results of operations satisfy.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Check {
    /// No two nodes are at one position.
    Nodes,
    /// The chain of a segment consists of edges, from end to end, in order.
    Chain,
    /// The nodes of a segment's chain are on it.
    OnSegment,
    /// Each edge is on a segment's chain.
    Edges,
    /// No two edges meet except in common nodes.
    Crossing,
    /// Euler's formula holds for vertices, edges, faces and components.
    Euler,
    /// Each side of an edge is on one boundary, and each boundary is of one face.
    Boundary,
    /// Each component is in its stated face.
    Nesting,
    /// Winding numbers change across an edge by the number of times that operands pass it.
    Winding,
    /// Outer loops are counterclockwise, holes clockwise, and all are closed.
    Orientation,
    /// The edges of a result do not cross.
    ResultCrossing,
    /// Areas of results add up, and equal the areas of the operands.
    Area,
    /// A point is inside a result if and only if its winding numbers in the operands say so.
    Membership,
}

impl Check {
    /// The name in findings.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Check::Nodes => "nodes",
            Check::Chain => "chain",
            Check::OnSegment => "node off its segment",
            Check::Edges => "edges",
            Check::Crossing => "undiscovered crossing",
            Check::Euler => "euler",
            Check::Boundary => "boundary",
            Check::Nesting => "nesting",
            Check::Winding => "winding",
            Check::Orientation => "loop orientation",
            Check::ResultCrossing => "crossing loops",
            Check::Area => "area",
            Check::Membership => "membership",
        }
    }

    /// True if the check is about lengths or areas, so that rounding of vertices alone can violate it. All other checks
    /// are about orientation and topology.
    #[must_use]
    pub const fn is_metric(self) -> bool {
        matches!(self, Check::OnSegment | Check::Area)
    }

    /// The law, as a statement.
    #[must_use]
    pub const fn law(self) -> &'static str {
        match self {
            Check::Nodes => "two nodes are not at the same place",
            Check::Chain => "the nodes on a segment go from one end to the other, in order",
            Check::OnSegment => "the nodes on a segment are on it",
            Check::Edges => "each edge joins consecutive nodes of a segment",
            Check::Crossing => "two edges have only a node in common",
            Check::Euler => "V - E + F = 1 + C",
            Check::Boundary => "each side of an edge belongs to one boundary of one face",
            Check::Nesting => "a component is in the face below the next edge above it",
            Check::Winding => "winding numbers change across an edge by the number of times that loops pass it",
            Check::Orientation => "outer loops are counterclockwise, holes clockwise, both closed",
            Check::ResultCrossing => "loops of a result do not cross",
            Check::Area => "|A or B| + |A and B| = |A| + |B|, |A not B| = |A| - |A and B|",
            Check::Membership => "a point is in a result by its winding numbers in the operands",
        }
    }
}

/// A violated law: the number of violations, and the first one.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Flaw {
    /// The law.
    pub check: Check,
    /// The number of violations.
    pub count: usize,
    /// The first violation, in words.
    pub what: String,
}

/// Flaws by law, in the order of their first violations.
#[derive(Default)]
struct Flaws(Vec<Flaw>);

impl Flaws {
    fn add(&mut self, check: Check, what: impl FnOnce() -> String) {
        match self.0.iter_mut().find(|flaw| flaw.check == check) {
            Some(flaw) => flaw.count += 1,
            None => self.0.push(Flaw { check, count: 1, what: what() }),
        }
    }
}

/// The stride that samples at most `most` of `count` items.
fn stride(count: usize, most: usize) -> usize {
    count.div_ceil(most.max(1)).max(1)
}
