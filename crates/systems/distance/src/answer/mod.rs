//! The nearest features of two objects.
//!
//! An object is a solid: its boundary and the inside. The boundary is a set of open simplices: vertices, edges without
//! their ends, and faces without their borders.
//!
//! # Pairs
//! A pair of features, one of each object, is nearest if one point of the first and one point of the second are at the
//! distance of the objects, and no other two of their points are. So a nearest pair has exactly one pair of points.
//! Parallel edges and coplanar faces have many points at the distance. These points are between the nearest pairs: the
//! pairs are the corners of the set of contacts.
//!
//! In the plane the pairs are vertex–vertex and vertex–edge. In space they are these, vertex–face, and edge–edge.

mod object;

use predicament_predicates::Vertex;

pub use object::Object;

/// An open simplex of a boundary.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Feature {
    /// A vertex.
    Vertex(Vertex),
    /// An edge by its vertices, ascending.
    Edge([Vertex; 2]),
    /// A face by its vertices, ascending.
    Face([Vertex; 3]),
}

impl Feature {
    /// The feature with these vertices in any order; `None` if there are not one to three different vertices.
    #[must_use]
    pub fn new(corners: &[Vertex]) -> Option<Feature> {
        let mut sorted = corners.to_vec();
        sorted.sort_unstable();
        match sorted[..] {
            [a] => Some(Feature::Vertex(a)),
            [a, b] if a < b => Some(Feature::Edge([a, b])),
            [a, b, c] if a < b && b < c => Some(Feature::Face([a, b, c])),
            _ => None,
        }
    }

    /// The vertices, ascending.
    #[must_use]
    pub fn corners(&self) -> &[Vertex] {
        match self {
            Feature::Vertex(v) => std::slice::from_ref(v),
            Feature::Edge(corners) => corners,
            Feature::Face(corners) => corners,
        }
    }

    /// The dimension: 0, 1 or 2.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.corners().len() - 1
    }

    /// The feature and all features at its border.
    #[must_use]
    pub fn closure(corners: &[Vertex]) -> Vec<Feature> {
        let subset = |mask: usize| {
            let (mut chosen, mut count) = ([corners[0]; 3], 0);
            for (_, &v) in corners.iter().enumerate().filter(|(at, _)| mask >> at & 1 == 1) {
                chosen[count] = v;
                count += 1;
            }
            Feature::new(&chosen[..count])
        };
        (1..1_usize << corners.len()).filter_map(subset).collect()
    }
}

impl std::fmt::Display for Feature {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Feature::Vertex(v) => write!(f, "vertex {v}"),
            Feature::Edge([a, b]) => write!(f, "edge {a} {b}"),
            Feature::Face([a, b, c]) => write!(f, "face {a} {b} {c}"),
        }
    }
}

/// A feature of the first object and one of the second.
pub type Pair = [Feature; 2];

/// The way in which two objects lie.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub enum Kind {
    /// The objects have no common point.
    #[default]
    Apart,
    /// The boundaries have common points and do not cross.
    Touching,
    /// The boundaries have common points. An edge of one object passes through the inside of a face of the other (in
    /// the plane: through an edge), or a vertex of one object is inside the other.
    Crossing,
    /// The boundaries have no common point, and a part of one object is inside the other.
    Contained,
}

impl Kind {
    /// The name in answers and findings.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Kind::Apart => "apart",
            Kind::Touching => "touching",
            Kind::Crossing => "crossing",
            Kind::Contained => "contained",
        }
    }

    /// True if the objects have a common point: their distance is zero.
    #[must_use]
    pub const fn is_zero(self) -> bool {
        !matches!(self, Kind::Apart)
    }
}

/// The nearest features of two objects.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Nearest {
    /// The way in which the objects lie.
    pub kind: Kind,
    /// All nearest pairs, ascending, if the objects are apart or touch. Empty if they cross or one is inside the other.
    pub pairs: Vec<Pair>,
}

/// Pairs in words: `vertex 3 and edge 7 8, vertex 4 and vertex 9`.
#[must_use]
pub fn describe(pairs: &[Pair]) -> String {
    let pair = |[first, second]: &Pair| format!("{first} and {second}");
    pairs.iter().map(pair).collect::<Vec<_>>().join(", ")
}
