//! The edges of closed loops of doubles: winding numbers, distances and crossings.

use std::cmp::Ordering;

use predicament_judge::boxes::{Boxes, extent};
use predicament_judge::rational;

use super::super::overlay::{Point, distance};

/// A point in doubles.
type Double = [f64; 2];

/// The edges of closed loops, with a search tree over them.
pub struct Edges {
    edges: Vec<[Double; 2]>,
    index: Boxes<2>,
    /// The largest coordinate.
    largest: f64,
}

impl Edges {
    /// The edges of loops, each closed from its last point to its first. Edges without a length are left out.
    pub fn new<'l>(loops: impl Iterator<Item = &'l Vec<Double>>) -> Edges {
        let sides = loops.flat_map(|one| one.iter().zip(one.iter().cycle().skip(1)).map(|(&a, &b)| [a, b]));
        let edges: Vec<[Double; 2]> = sides.filter(|[a, b]| a != b).collect();
        let index = Boxes::new(edges.iter().map(|&ends| extent(ends)).collect());
        let largest = edges.as_flattened().as_flattened().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        Edges { edges, index, largest }
    }

    /// All edges.
    #[must_use]
    pub fn all(&self) -> &[[Double; 2]] {
        &self.edges
    }

    /// The winding number of the loops around a point; `None` for a point on an edge.
    ///
    /// It is exact, as that of the overlay's own checks is. Those have rational points and edges with supports. Here
    /// all are doubles. The search tree leaves the edges that meet the ray to the right, and most of them are settled
    /// by comparing doubles, which makes tens of thousands of points affordable.
    #[must_use]
    pub fn winding(&self, p: Double) -> Option<i32> {
        let (mut winding, mut is_on) = (0, false);
        self.index.each_near(&[p, [f64::INFINITY, p[1]]], 0.0, |edge| {
            let [a, b] = self.edges[edge as usize];
            let is_below = [a[1] <= p[1], b[1] <= p[1]];
            if is_below[0] == is_below[1] {
                let is_level = a[1] == p[1] && b[1] == p[1] || a == p || b == p;
                is_on |= is_level && a[0].min(b[0]) <= p[0] && p[0] <= a[0].max(b[0]);
                return;
            }
            match (side(a, b, p), is_below[0]) {
                (Ordering::Equal, _) => is_on = true,
                (Ordering::Greater, true) => winding += 1,
                (Ordering::Less, false) => winding -= 1,
                _ => {}
            }
        });
        (!is_on).then_some(winding)
    }

    /// The distance of a point from the nearest edge, computed in rationals and rounded once; infinite without edges.
    /// The search begins at a distance.
    #[must_use]
    pub fn distance(&self, p: Double, from: f64) -> f64 {
        if self.edges.is_empty() {
            return f64::INFINITY;
        }
        let at = p.map(rational);
        let mut near = Vec::new();
        let mut reach = from.max(f64::MIN_POSITIVE);
        loop {
            self.index.near(&[p, p], reach, &mut near);
            let is_all = near.len() == self.edges.len();
            // Edges that are surely farther than another one are not computed exactly.
            let rough: Vec<f64> = near.iter().map(|&edge| self.rough(edge, p)).collect();
            let most = rough.iter().copied().fold(f64::INFINITY, f64::min) + 2.0 * self.slack(p);
            let of = |(&edge, _): (&u32, &f64)| self.exact(edge, &at);
            let least = near.iter().zip(&rough).filter(|(_, off)| off.is_nan() || **off <= most).map(of);
            let least = least.fold(f64::INFINITY, f64::min);
            // Every edge within the reach is near.
            if least <= reach || is_all {
                return least;
            }
            reach *= 64.0;
        }
    }

    /// True if the point is within a distance of an edge; also true for points that are a few roundings farther.
    #[must_use]
    pub fn is_within(&self, p: Double, distance: f64) -> bool {
        let reach = distance + self.slack(p);
        let mut near = Vec::new();
        self.index.near(&[p, p], reach, &mut near);
        near.iter().any(|&edge| {
            let off = self.rough(edge, p);
            let off = if off.is_nan() { self.exact(edge, &p.map(rational)) } else { off };
            off <= reach
        })
    }

    /// The distance of a point from an edge, computed in rationals and rounded once.
    fn exact(&self, edge: u32, p: &Point) -> f64 {
        let [a, b] = self.edges[edge as usize].map(|end| end.map(rational));
        distance(&a, &b, p)
    }

    /// A bound of the error of [`rough`](Edges::rough): 8 units of 2^-52 of the largest coordinate.
    fn slack(&self, p: Double) -> f64 {
        (self.largest + p[0].abs().max(p[1].abs())) * 2.0_f64.powi(-49)
    }

    /// The distance of a point from an edge, in doubles; NaN if products may leave the range of doubles.
    fn rough(&self, edge: u32, p: Double) -> f64 {
        let [a, b] = self.edges[edge as usize];
        let [along, to] = [[b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]];
        let square = along[0] * along[0] + along[1] * along[1];
        if !(1e-280..1e300).contains(&square) {
            return f64::NAN;
        }
        let part = ((along[0] * to[0] + along[1] * to[1]) / square).clamp(0.0, 1.0);
        (to[0] - part * along[0]).hypot(to[1] - part * along[1])
    }

    /// Two edges that cross with all ends farther than a distance from the other edge, in words; an even sample of
    /// edges is compared with all edges near them.
    #[must_use]
    pub fn crossing(&self, distance: f64, most: usize) -> Option<String> {
        let step = self.edges.len().div_ceil(most.max(1)).max(1);
        let mut near = Vec::new();
        for at in (0..self.edges.len()).step_by(step) {
            self.index.near(&self.index.all()[at], 0.0, &mut near);
            for other in near.iter().map(|&other| other as usize).filter(|&other| other != at) {
                let ([a, b], [c, d]) = (self.edges[at], self.edges[other]);
                let parts = side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
                let is_proper = [side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b)].iter().all(|s| s.is_ne());
                if parts && is_proper && self.is_deep([at, other], distance) {
                    return Some(format!("the edge from {a:?} to {b:?} crosses that from {c:?} to {d:?}"));
                }
            }
        }
        None
    }

    /// True if all ends of two edges are farther than a distance from the other edge.
    fn is_deep(&self, pair: [usize; 2], least: f64) -> bool {
        let exact = pair.map(|at| self.edges[at].map(|end| -> Point { end.map(rational) }));
        [[0, 1], [1, 0]].into_iter().all(|[one, other]| {
            let [a, b] = &exact[other];
            exact[one].iter().all(|end| distance(a, b, end) > least)
        })
    }
}

/// The side of p on the line from a to b, exactly.
fn side(a: Double, b: Double, p: Double) -> Ordering {
    let [left, right] = [(b[0] - a[0]) * (p[1] - a[1]), (b[1] - a[1]) * (p[0] - a[0])];
    let (turn, size) = (left - right, left.abs() + right.abs());
    // With u = 2^-53, each product has an error below 3u + 3u² + u³ of it, and the difference a further u: together
    // below 5u of the sum of both. If that sum is small, a product may have underflowed.
    if size > 1e-280 && size.is_finite() && turn.abs() > size * 2.0_f64.powi(-50) {
        return turn.total_cmp(&0.0);
    }
    let [a, b, p] = [a, b, p].map(|point| point.map(rational));
    super::super::overlay::side(&a, &b, &p)
}
