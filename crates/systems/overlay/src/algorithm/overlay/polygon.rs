//! Polygons whose edges know the input segments that they are on.

use predicament_predicates::Vertex;

/// An edge: a part of an input segment.
///
/// Its ends are input vertices, or constructed ones where two input segments cross. Whatever is constructed on it
/// later is where its *support* crosses that of another edge, so an overlay of results of overlays constructs vertices from
/// input vertices, as the first one did.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Edge {
    /// Where it begins.
    pub from: Vertex,
    /// Where it ends.
    pub to: Vertex,
    /// The ends of an input segment that it is a part of, in either order.
    pub support: [Vertex; 2],
}

impl Edge {
    /// A whole input segment.
    #[must_use]
    pub const fn whole(from: Vertex, to: Vertex) -> Edge {
        Edge { from, to, support: [from, to] }
    }

    /// The same from its end to its beginning.
    #[must_use]
    pub const fn reversed(self) -> Edge {
        Edge { from: self.to, to: self.from, support: self.support }
    }
}

/// The rule by which a winding number says whether a point is inside of a polygon.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Rule {
    /// Inside where it is odd.
    #[default]
    EvenOdd,
    /// Inside where it is not zero.
    NonZero,
}

impl Rule {
    /// Whether a winding number is one of the inside.
    #[must_use]
    pub const fn is_inside(self, winding: i32) -> bool {
        match self {
            Rule::EvenOdd => winding % 2 != 0,
            Rule::NonZero => winding != 0,
        }
    }
}

/// Loops that may cross themselves and each other, and the rule that says what is inside.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Polygon {
    /// Closed chains: each edge begins where the one before it ends.
    pub loops: Vec<Vec<Edge>>,
    /// The rule that says what is inside.
    pub rule: Rule,
}

impl Polygon {
    /// The polygon of loops of input vertices; edges without length are left out.
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
/// Loops are simple: no vertex comes twice. The inside is on the left of each edge. Edges meet in
/// vertices only; those that follow each other on one input segment are one, but where another loop touches. Each loop begins at its first vertex in the order of ids, and so do holes and regions follow each other.
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
