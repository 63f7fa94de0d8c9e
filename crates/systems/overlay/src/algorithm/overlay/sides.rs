//! Edges that certainly do not meet a polygon, by estimates with error bounds.
//!
//! Both ends of an edge are strictly on one side of a line: then the edge meets no segment of the line. So an edge that
//! is on one side of each edge of a polygon, or off its box, meets nothing of the polygon.
//!
//! # The bound
//! Let d = b − a be the direction of a line, p − a the way to a vertex, and e the error of the vertex's position. The
//! computed determinant dₓ(p − a)ᵧ − dᵧ(p − a)ₓ has two products of two differences. Their roundings add less than 6u
//! of the products' magnitudes, u = 2^-53, and the position adds |dₓ|eᵧ + |dᵧ|eₓ, the roundings of d aside. The bound
//! takes 9u and a thousandth more; the least normal double covers underflow. Overflow makes the bound infinite or not
//! a number, and then the side is not known.

use predicament_predicates::{Plane, Predicates, Vertex};

use super::polygon::Polygon;
use super::reach::{Extent, edge_extent, place};

/// The maximum number of lines: each has a bit of a mask. Polygons of more edges are compared by their box.
const MOST: usize = 32;

/// The box that contains nothing.
pub(super) const NOTHING: Extent = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];

/// The smallest box that contains two boxes.
pub(super) fn joined(all: Extent, one: Extent) -> Extent {
    [all[0].min(one[0]), all[1].min(one[1]), all[2].max(one[2]), all[3].max(one[3])]
}

/// True if two closed boxes have a point in common.
#[inline]
pub(super) fn meets(one: &Extent, other: &Extent) -> bool {
    (one[0] <= other[2]) & (other[0] <= one[2]) & (one[1] <= other[3]) & (other[1] <= one[3])
}

/// A vertex by its position, within an error.
pub(super) struct Spot {
    at: [f64; 2],
    error: [f64; 2],
    /// A box that contains the vertex.
    pub extent: Extent,
}

impl Spot {
    pub fn new(session: &dyn Predicates, v: Vertex) -> Spot {
        let known = place(session, v).filter(|(at, error)| at.iter().chain(error).all(|x| x.is_finite()));
        let Some((at, error)) = known else {
            let [far, near] = [f64::INFINITY, f64::NEG_INFINITY];
            return Spot { at: [0.0; 2], error: [far; 2], extent: [near, near, far, far] };
        };
        let extent = if v.is_constructed() {
            let ends = [0, 1].map(|axis: usize| [at[axis] - error[axis], at[axis] + error[axis]]);
            [ends[0][0].next_down(), ends[1][0].next_down(), ends[0][1].next_up(), ends[1][1].next_up()]
        } else {
            [at[0], at[1], at[0], at[1]]
        };
        Spot { at, error, extent }
    }
}

/// The edges of a polygon, to tell what is apart from them.
pub(super) struct Lines {
    /// The box of all edges.
    pub bounds: Extent,
    /// Empty if there are more than [`MOST`].
    lines: Vec<Line>,
}

struct Line {
    start: [f64; 2],
    along: [f64; 2],
    /// The box of the edge.
    extent: Extent,
}

impl Lines {
    pub fn new(session: &dyn Predicates, polygon: &Polygon) -> Lines {
        let scene = session.scene();
        let mut bounds = NOTHING;
        let mut lines = Vec::new();
        for &edge in polygon.loops.iter().flatten() {
            let extent = edge_extent(session, edge);
            bounds = joined(bounds, extent);
            if lines.len() <= MOST {
                let [a, b] = edge.support.map(|v| scene.point2(Plane::Xy, v));
                lines.push(Line { start: a, along: [b[0] - a[0], b[1] - a[1]], extent });
            }
        }
        if lines.len() > MOST {
            lines.clear();
        }
        Lines { bounds, lines }
    }

    /// True if the edge between two vertices may meet the polygon's edges.
    #[inline]
    pub fn may_meet(&self, ends: [&Spot; 2]) -> bool {
        let extent = joined(ends[0].extent, ends[1].extent);
        if !meets(&extent, &self.bounds) {
            return false;
        }
        let near = |line: &Line| meets(&extent, &line.extent) && line.may_meet(ends);
        self.lines.is_empty() || self.lines.iter().any(near)
    }
}

impl Line {
    /// True unless two vertices are certainly on one side of the line.
    #[inline]
    fn may_meet(&self, ends: [&Spot; 2]) -> bool {
        let [from, to] = ends.map(|end| self.side(end));
        from == 0 || from != to
    }

    /// The sign of a vertex's side; zero if it is not certain.
    #[inline]
    fn side(&self, spot: &Spot) -> i8 {
        let [x, y] = [spot.at[0] - self.start[0], spot.at[1] - self.start[1]];
        let products = [self.along[0] * y, self.along[1] * x];
        let determinant = products[0] - products[1];
        let rounding = 1e-15 * (products[0].abs() + products[1].abs());
        let moved = 1.001 * (self.along[0].abs() * spot.error[1] + self.along[1].abs() * spot.error[0]);
        let bound = rounding + moved + f64::MIN_POSITIVE;
        i8::from(determinant > bound) - i8::from(determinant < -bound)
    }
}
