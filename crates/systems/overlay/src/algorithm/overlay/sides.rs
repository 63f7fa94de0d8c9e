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

use super::polygon::{Edge, Polygon};
use super::reach::{Extent, edge_extent, extent, place};

/// The maximum number of lines: each has a bit of a mask. Polygons of more edges are compared by their box.
const MOST: usize = 32;

/// The number of consecutive edges that are compared together first.
const TOGETHER: usize = 16;

/// The box that contains nothing.
pub(super) const NOTHING: Extent = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];

/// The smallest box that contains two boxes.
pub(super) fn joined(all: Extent, one: Extent) -> Extent {
    // (Not `f64::min`, which looks for NaN.)
    let [low, high] = [|x: f64, y: f64| if x < y { x } else { y }, |x: f64, y: f64| if x > y { x } else { y }];
    [low(all[0], one[0]), low(all[1], one[1]), high(all[2], one[2]), high(all[3], one[3])]
}

/// True if two closed boxes have a point in common.
#[inline]
pub(super) fn meets(one: &Extent, other: &Extent) -> bool {
    (one[0] <= other[2]) & (other[0] <= one[2]) & (one[1] <= other[3]) & (other[1] <= one[3])
}

/// A box that contains all within a distance of a box along each axis.
fn widened(extent: Extent, by: [f64; 2]) -> Extent {
    let [low, high] = [[extent[0] - by[0], extent[1] - by[1]], [extent[2] + by[0], extent[3] + by[1]]];
    [low[0].next_down(), low[1].next_down(), high[0].next_up(), high[1].next_up()]
}

/// A vertex by its position, within an error.
#[derive(Clone, Copy)]
pub(super) struct Spot {
    at: [f64; 2],
    error: [f64; 2],
    /// A box that contains the vertex.
    pub extent: Extent,
}

impl Spot {
    /// A vertex at a point.
    #[inline]
    pub fn at(at: [f64; 2]) -> Spot {
        Spot { at, error: [0.0; 2], extent: [at[0], at[1], at[0], at[1]] }
    }

    /// All points of the box of some boxes.
    fn of_all(extents: impl Iterator<Item = Extent>) -> Spot {
        let extent = extents.fold(NOTHING, joined);
        // Four roundings, each of less than 2^-52 of the magnitude.
        let error = |low: f64, high: f64| (high - low) / 2.0 + 4.0 * f64::EPSILON * (low.abs() + high.abs());
        Spot {
            at: [extent[0].midpoint(extent[2]), extent[1].midpoint(extent[3])],
            error: [error(extent[0], extent[2]), error(extent[1], extent[3])],
            extent,
        }
    }

    pub fn new(session: &dyn Predicates, v: Vertex) -> Spot {
        let known = place(session, v).filter(|(at, error)| at.iter().chain(error).all(|x| x.is_finite()));
        let Some((at, error)) = known else {
            let [far, near] = [f64::INFINITY, f64::NEG_INFINITY];
            return Spot { at: [0.0; 2], error: [far; 2], extent: [near, near, far, far] };
        };
        if !v.is_constructed() {
            return Spot::at(at);
        }
        Spot { at, error, extent: widened([at[0], at[1], at[0], at[1]], error) }
    }
}

/// The positions of constructed vertices, which do not change while a session constructs others.
#[derive(Default)]
pub struct Known(Vec<Option<Spot>>);

impl Known {
    /// The position of a vertex.
    pub(super) fn spot(&mut self, session: &dyn Predicates, v: Vertex) -> Spot {
        let Some(at) = v.construction() else { return Spot::new(session, v) };
        if at >= self.0.len() {
            self.0.resize(at + 1, None);
        }
        *self.0[at].get_or_insert_with(|| Spot::new(session, v))
    }
}

/// The edges of a polygon, to tell what is apart from them.
#[derive(Clone, PartialEq, Debug)]
pub struct Lines {
    /// The box of all edges.
    pub(super) bounds: Extent,
    /// Empty if there are more than [`MOST`].
    lines: Vec<Line>,
}

#[derive(Clone, PartialEq, Debug)]
struct Line {
    start: [f64; 2],
    along: [f64; 2],
    /// A part of the bound of every determinant.
    slack: f64,
    /// The box of the edge.
    extent: Extent,
}

impl Lines {
    /// The lines of some segments, where all within a distance along each axis counts as the segment.
    #[must_use]
    pub fn around(segments: &[[[f64; 2]; 2]], distance: f64) -> Lines {
        let widened = |segment| widened(extent(segment), [distance; 2]);
        Lines::collected(segments.iter().map(|segment| (*segment, widened(segment))), distance)
    }

    pub(super) fn new(session: &dyn Predicates, polygon: &Polygon) -> Lines {
        let scene = session.scene();
        let ends = |edge: &Edge| edge.support.map(|v| scene.point2(Plane::Xy, v));
        let edges = polygon.loops.iter().flatten();
        Lines::collected(edges.map(|edge| (ends(edge), edge_extent(session, *edge))), 0.0)
    }

    /// Lines through two points each, with the box of the part that is an edge.
    fn collected(edges: impl Iterator<Item = ([[f64; 2]; 2], Extent)>, distance: f64) -> Lines {
        let mut bounds = NOTHING;
        let mut lines = Vec::new();
        for ([a, b], extent) in edges {
            bounds = joined(bounds, extent);
            if lines.len() <= MOST {
                let along = [b[0] - a[0], b[1] - a[1]];
                let slack = 1.001 * (along[0].abs() + along[1].abs()) * distance + f64::MIN_POSITIVE;
                lines.push(Line { start: a, along, slack, extent });
            }
        }
        if lines.len() > MOST {
            lines.clear();
        }
        Lines { bounds, lines }
    }

    /// Finds the edges of a closed loop that may meet one of the segments: appends true or false for each edge.
    pub fn near_edges(&self, ring: &[[f64; 2]], is_near: &mut Vec<bool>) {
        self.near(ring, |&at| Spot::at(at), is_near);
    }

    /// As [`Lines::near_edges`], for vertices.
    pub(super) fn near_between(&self, ring: &[Spot], is_near: &mut Vec<bool>) {
        self.near(ring, |&spot| spot, is_near);
    }

    #[inline]
    fn near<T>(&self, ring: &[T], spot: impl Fn(&T) -> Spot, is_near: &mut Vec<bool>) {
        let Some(first) = ring.first() else { return };
        // Most edges are far from all segments, and are so together with their neighbours.
        for start in (0..ring.len()).step_by(TOGETHER) {
            let end = ring.len().min(start + TOGETHER);
            let after = ring.get(end).unwrap_or(first);
            let all = Spot::of_all(ring[start..end].iter().chain([after]).map(|one| spot(one).extent));
            if !self.may_meet([&all, &all]) {
                is_near.resize(is_near.len() + end - start, false);
                continue;
            }
            let mut from = spot(&ring[start]);
            for to in ring[start + 1..end].iter().chain([after]) {
                let to = spot(to);
                is_near.push(self.may_meet([&from, &to]));
                from = to;
            }
        }
    }

    /// Finds the points that may be on one of the segments; appends their indices.
    pub fn near_points(&self, points: &[[f64; 2]], found: &mut Vec<usize>) {
        let is_near = |point: &[f64; 2]| {
            let spot = Spot::at(*point);
            self.may_meet([&spot, &spot])
        };
        found.extend((0..points.len()).filter(|&at| is_near(&points[at])));
    }

    /// True if the edge between two vertices may meet one of the edges.
    #[inline]
    pub(super) fn may_meet(&self, ends: [&Spot; 2]) -> bool {
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
        let bound = rounding + moved + self.slack;
        i8::from(determinant > bound) - i8::from(determinant < -bound)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points on a segment, exact for multiples of an eighth.
    fn on([a, b]: [[f64; 2]; 2]) -> impl Iterator<Item = [f64; 2]> {
        (0..=8).map(move |part| [0, 1].map(|axis| a[axis] + (b[axis] - a[axis]) * f64::from(part) / 8.0))
    }

    #[test]
    fn edges_and_points_within_the_distance_are_found() {
        let mut state = 7_u64;
        let mut below = |bound: u32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            f64::from(u32::try_from(state >> 33).unwrap() % bound)
        };
        let (mut left_out, mut found) = (0, 0);
        for round in 0..200 {
            let distance = [0.0, 0.25, 2.0][round % 3];
            // A ring of short edges, which are compared together, and sometimes long ones.
            let mut at = [below(64), below(64)];
            let ring: Vec<[f64; 2]> = (0..40)
                .map(|_| {
                    let reach = if below(20) == 0.0 { 65 } else { 5 };
                    at = at.map(|x| x + below(reach) - f64::from(reach / 2));
                    at
                })
                .collect();
            let count = [1, 4, 40][round % 3];
            let segments: Vec<[[f64; 2]; 2]> = (0..count).map(|_| [(); 2].map(|()| [below(64), below(64)])).collect();
            let lines = Lines::around(&segments, distance);
            let is_close = |p: [f64; 2]| {
                let apart = |q: [f64; 2]| (p[0] - q[0]).abs().max((p[1] - q[1]).abs());
                segments.iter().any(|&segment| on(segment).any(|q| apart(q) <= distance))
            };
            let mut is_near = Vec::new();
            lines.near_edges(&ring, &mut is_near);
            assert_eq!(is_near.len(), ring.len());
            for (at, is_near) in is_near.into_iter().enumerate() {
                let edge = [ring[at], ring[(at + 1) % ring.len()]];
                let is_close = on(edge).any(is_close);
                assert!(is_near || !is_close, "{edge:?} is within {distance} of {segments:?}");
                left_out += usize::from(!is_near);
                found += usize::from(is_close);
            }
            let mut points = Vec::new();
            lines.near_points(&ring, &mut points);
            assert!((0..ring.len()).all(|at| points.contains(&at) || !is_close(ring[at])));
        }
        assert!(left_out > 1000 && found > 200, "{left_out} and {found} of 8000");
    }
}
