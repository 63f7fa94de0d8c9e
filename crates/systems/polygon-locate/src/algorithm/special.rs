//! The paper's own test (Franklin & Magalhães, 4.2, steps 1 to 6), which has the
//! perturbation built into its comparisons.
//!
//! It is here to be held against the generic code, which asks a session and
//! knows no coordinates. This one knows coordinates and no session: all that
//! it has to be given is the sign of one determinant. Where the paper is wrong
//! as printed, this is right: a point is inside iff the number of crossings is
//! *odd*.
//!
//! # What step 5 reports
//! A point with D = 0 in the half-open x-range l ≤ p < r of an edge is on the
//! edge, which the paper does not consider: the test returns an error. These
//! are not all points on boundaries. On a vertical edge, and on a vertex that
//! no edge has as its left end, the test returns without a word; its answer is
//! then that for the point moved to the right.
//!
//! # What Simulation of Simplicity makes of it
//! x_i → x_i + ε^(2^i) moves a query that is numbered before all vertices of
//! the map further than them, and further to the right than up: so l ≤ p < r
//! is that query's order, edge by edge, and wherever step 5 has no error both
//! codes answer the same, on boundaries too. For a query that is numbered
//! last the vertices move instead, the order is l < p ≤ r, and the answers are
//! the same where the query is on no boundary.
//!
//! # In four forms
//! [`crosses`] is the test of one edge. [`locate`] goes through all edges of
//! all regions and shares nothing else with the rest of this module.
//! [`LocateIndex::locate_specially`] and [`LocateIndex::question_specially`]
//! have the broad phase and the sums in common with the generic code and
//! nothing else: for comparing speed.

use predicament_mesh::{PolygonMap, Region};
use predicament_predicates::{Plane, Scene, Sign, Vertex};

use super::single::Mark;
use super::{LocateIndex, Location, Scratch};

/// A place in the plane.
pub type Point = [f64; 2];

/// The error of step 5: the point is on the edge, in its half-open x-range.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct OnEdge;

impl std::fmt::Display for OnEdge {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("the point is on an edge; ask a session that breaks ties")
    }
}

impl std::error::Error for OnEdge {}

/// Whether the ray up from `p` crosses an edge, given by both ends in either order.
///
/// `sign_of_d` is asked for l, r and p, l left of r, in step 4 only. It has to
/// be the exact sign of
///
/// ```text
///     | l.x  l.y  1 |
/// D = | r.x  r.y  1 |
///     | p.x  p.y  1 |
/// ```
///
/// which is negative where p is below the edge.
///
/// # Errors
/// [`OnEdge`] where D is zero.
#[inline]
pub fn crosses(
    p: Point,
    [v, w]: [Point; 2],
    sign_of_d: impl FnOnce(Point, Point, Point) -> Sign,
) -> Result<bool, OnEdge> {
    if v[0] == w[0] {
        return Ok(false); // step 1
    }
    let [l, r] = if v[0] < w[0] { [v, w] } else { [w, v] }; // step 2
    if l[0] > p[0] || p[0] >= r[0] {
        return Ok(false); // step 3
    }
    match sign_of_d(l, r, p) {
        Sign::Zero => Err(OnEdge),
        Sign::Negative => Ok(true),
        Sign::Positive => Ok(false),
    }
}

/// Whether `p` is inside each region, every edge of it tested.
///
/// An edge that a region uses an even number of times bounds nothing: a point
/// on it is not on the region's boundary.
///
/// # Panics
/// If the scene lacks vertices of the map.
pub fn locate(
    map: &PolygonMap,
    scene: &Scene,
    p: Point,
    sign_of_d: &impl Fn(Point, Point, Point) -> Sign,
) -> Vec<Result<bool, OnEdge>> {
    let inside = |region: &Region| {
        let mut odd = false;
        let mut on: Vec<[Vertex; 2]> = Vec::new();
        for [a, b] in region.rings.iter().flat_map(|ring| ring.edges()) {
            match crosses(p, [a, b].map(|v| scene.point2(Plane::Xy, v)), sign_of_d) {
                Ok(crossed) => odd ^= crossed,
                Err(OnEdge) => {
                    let edge = [a.min(b), a.max(b)];
                    match on.iter().position(|&other| other == edge) {
                        Some(before) => drop(on.swap_remove(before)),
                        None => on.push(edge),
                    }
                }
            }
        }
        if on.is_empty() { Ok(odd) } else { Err(OnEdge) }
    };
    map.regions().iter().map(inside).collect()
}

impl LocateIndex {
    /// Where `p` is, for all regions in one pass, by the paper's own test: a
    /// region whose edge has the error of step 5 is in `boundary`.
    ///
    /// The edges near `p` are those of [`locate`](LocateIndex::locate), and D
    /// is asked for, as there, only where the box of the edge holds `p`.
    ///
    /// # Panics
    /// If a coordinate of `p` is not finite.
    pub fn locate_specially<'a>(
        &'a self,
        p: Point,
        sign_of_d: &impl Fn(Point, Point, Point) -> Sign,
        scratch: &'a mut Scratch,
    ) -> Location<'a> {
        let [x, y] = p;
        assert!(x.is_finite() && y.is_finite(), "[{x}, {y}] is no place in the plane: coordinates must be finite");
        let cell = self.cells().at(x, [y, y]).expect("a height is in one row");
        scratch.fit(self);
        for entry in cell.entries {
            let past = entry.pivot.is_some_and(|end| entry.ends[end as usize][0] <= x);
            let crossed = crosses(p, entry.ends, |l, r, p| beside(l, r, p).unwrap_or_else(|| sign_of_d(l, r, p)));
            let mark = Mark { odd: past ^ (crossed == Ok(true)), on_boundary: crossed == Err(OnEdge), touched: false };
            if mark.odd | mark.on_boundary {
                scratch.add(self.owners_of(entry.segment), mark);
            }
        }
        scratch.sum_up_under(self, cell.above)
    }

    /// The same of every edge that is not below the vertex `q`, as in
    /// [`question`](LocateIndex::question): D is asked for wherever the
    /// paper's test needs it, and nothing is decided by boxes.
    ///
    /// # Panics
    /// If the scene lacks `q` or vertices of the map.
    pub fn question_specially<'a>(
        &self,
        scene: &Scene,
        q: Vertex,
        sign_of_d: &impl Fn(Point, Point, Point) -> Sign,
        scratch: &'a mut Scratch,
    ) -> Location<'a> {
        let point = |v| scene.point2(Plane::Xy, v);
        let p = point(q);
        scratch.fit(self);
        for edge in self.columns().above(p, 0.0) {
            let crossed = crosses(p, self.ends(edge).map(point), sign_of_d);
            if crossed != Ok(false) {
                let mark = Mark { odd: crossed == Ok(true), on_boundary: crossed == Err(OnEdge), touched: false };
                scratch.add(self.owners_of(edge), mark);
            }
        }
        scratch.sum_up(self)
    }
}

/// The sign of D for a point above or below both ends: no arithmetic is needed.
#[inline]
fn beside(l: Point, r: Point, p: Point) -> Option<Sign> {
    if p[1] > l[1].max(r[1]) {
        Some(Sign::Positive)
    } else if p[1] < l[1].min(r[1]) {
        Some(Sign::Negative)
    } else {
        None
    }
}
