//! Polygons whose edges store the input segments that they are on.

use predicament_predicates::Vertex;

/// An edge: a part of an input segment.
///
/// Its ends are input vertices, or constructed vertices where two input segments cross. Any vertex constructed on it
/// later is the crossing of its *support* with that of another edge. So an overlay of results of overlays constructs
/// vertices from input vertices, as the first overlay did.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Edge {
    /// The first vertex.
    pub from: Vertex,
    /// The last vertex.
    pub to: Vertex,
    /// The ends of an input segment that contains it, in either order.
    pub support: [Vertex; 2],
}

impl Edge {
    /// The edge that is a whole input segment.
    #[must_use]
    pub const fn whole(from: Vertex, to: Vertex) -> Edge {
        Edge { from, to, support: [from, to] }
    }

    /// The edge in the other direction.
    #[must_use]
    pub const fn reversed(self) -> Edge {
        Edge { from: self.to, to: self.from, support: self.support }
    }
}

/// The rule by which a winding number decides if a point is inside a polygon.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Rule {
    /// Inside if the winding number is odd.
    #[default]
    EvenOdd,
    /// Inside if the winding number is not zero.
    NonZero,
}

impl Rule {
    /// True if a point with this winding number is inside.
    #[must_use]
    pub const fn is_inside(self, winding: i32) -> bool {
        match self {
            Rule::EvenOdd => winding % 2 != 0,
            Rule::NonZero => winding != 0,
        }
    }
}

/// Loops that may cross themselves and each other, and the rule for their inside.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Polygon {
    /// Closed chains: each edge begins at the end of the edge before.
    pub loops: Vec<Vec<Edge>>,
    /// The rule for the inside.
    pub rule: Rule,
}

impl Polygon {
    /// Builds a polygon from loops of input vertices; edges without length are left out.
    #[must_use]
    pub fn of_vertices(loops: &[Vec<Vertex>], rule: Rule) -> Polygon {
        let edges = |one: &Vec<Vertex>| {
            let ends = one.iter().zip(one.iter().cycle().skip(1));
            ends.filter(|(from, to)| from != to).map(|(&from, &to)| Edge::whole(from, to)).collect()
        };
        Polygon { loops: loops.iter().map(edges).collect(), rule }
    }
}

/// A region of the plane: an outer loop, and holes in it.
///
/// Loops are simple: no vertex occurs twice. The inside is on the left of each edge. Edges meet in vertices only.
/// Consecutive edges on one input segment are merged, except where another loop touches. Each loop begins at its first
/// vertex in the order of ids; holes and regions are sorted the same way.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Region {
    /// The outer loop, counterclockwise.
    pub outer: Vec<Edge>,
    /// The holes, clockwise.
    pub holes: Vec<Vec<Edge>>,
}

impl Region {
    /// The outer loop, then the holes.
    pub fn loops(&self) -> impl Iterator<Item = &Vec<Edge>> {
        std::iter::once(&self.outer).chain(&self.holes)
    }
}

/// The polygon of all loops of regions, by the non-zero rule: an operand of another overlay.
impl From<&[Region]> for Polygon {
    fn from(regions: &[Region]) -> Polygon {
        let loops = regions.iter().flat_map(|region| region.loops().cloned()).collect();
        Polygon { loops, rule: Rule::NonZero }
    }
}
