//! Arrangements of segments and results of Boolean operations, decided in rationals.
//!
//! Nothing here knows how they were made: there are points, and numbers of points. Each [`Check`] is a law. Together they say
//! that an arrangement is one of *all* its segments, that its faces are faces, and that results hold the points that they
//! should.
//!
//! # What broken ties change
//! In a scene that was perturbed by infinitesimals nothing touches. Seen in the scene as it is, edges then may touch and
//! overlap, faces may have no area, and nodes may be at one place; but no two edges cross, areas are what they are, and
//! points off all edges are inside or outside as they were. [`Expected::has_areas`] says which is asked.

mod graph;
mod operations;
mod plane;
mod regions;
mod windings;

pub use graph::Graph;
pub use operations::{Operands, Results};
pub use plane::Point;
pub use regions::{Defects, Shape, winding_of};
pub use windings::Windings;

/// What arrangements and results are held to, and how much of them is looked at.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Expected {
    /// Nothing was perturbed: nodes are at different places, and faces have areas.
    pub has_areas: bool,
    /// How many edges are held against those near them, at most; they are spread evenly.
    pub edges_crossed: usize,
    /// How many components are looked for in their faces, and how many points are located.
    pub located: usize,
}

/// A law that arrangements and results of operations satisfy.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Check {
    /// No two nodes are at one place.
    Nodes,
    /// The chain of a segment is of edges, from end to end, in order.
    Chain,
    /// The nodes of a segment's chain are on it.
    OnSegment,
    /// Each edge is on a segment's chain.
    Edges,
    /// No two edges meet but in nodes that they share.
    Crossing,
    /// Vertices, edges, faces and components add up.
    Euler,
    /// Each side of an edge is on one boundary, and each boundary is of one face.
    Boundary,
    /// Each component is in the face that it is said to be in.
    Nesting,
    /// Winding numbers change across an edge by the number of times that it is passed.
    Winding,
    /// Outer loops are counterclockwise, holes clockwise, and all are closed.
    Orientation,
    /// The edges of a result do not cross.
    ResultCrossing,
    /// Areas of results add up, and are those of the operands.
    Area,
    /// Points are inside of results by their winding numbers in the operands.
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

    /// Whether it is about lengths or areas, so that vertices that are rounded are enough to violate it. All others are about how
    /// things turn and hang together.
    #[must_use]
    pub const fn is_metric(self) -> bool {
        matches!(self, Check::OnSegment | Check::Area)
    }

    /// The law, as a statement.
    #[must_use]
    pub const fn law(self) -> &'static str {
        match self {
            Check::Nodes => "no two nodes are at one place",
            Check::Chain => "the nodes on a segment go from one end to the other, in order",
            Check::OnSegment => "the nodes on a segment are on it",
            Check::Edges => "each edge is between nodes that follow each other on a segment",
            Check::Crossing => "two edges have no point in common but a common node",
            Check::Euler => "V - E + F = 1 + C",
            Check::Boundary => "each side of an edge is on one boundary of one face",
            Check::Nesting => "a component is in the face below the next edge above it",
            Check::Winding => "winding numbers change across an edge by the number of times that loops pass it",
            Check::Orientation => "outer loops are counterclockwise, holes clockwise, both closed",
            Check::ResultCrossing => "loops of a result do not cross",
            Check::Area => "|A or B| + |A and B| = |A| + |B|, |A not B| = |A| - |A and B|",
            Check::Membership => "a point is in a result by its winding numbers in the operands",
        }
    }
}

/// How often a law is violated, and where first.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Flaw {
    /// The law.
    pub check: Check,
    /// How often.
    pub count: usize,
    /// The first time, in words.
    pub what: String,
}

/// Flaws by their laws, in the order in which they were first found.
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

/// Every n-th of so many, that they are no more than `most`.
fn stride(count: usize, most: usize) -> usize {
    count.div_ceil(most.max(1)).max(1)
}
