//! The paper's own test (Franklin & Magalhães, 4.2, steps 1 to 6), whose comparisons contain the perturbation.
//!
//! It serves to check the generic code, which queries a session and never uses coordinates. The paper's test uses
//! coordinates and no session: its only external input is the sign of one determinant. It corrects the paper's
//! misprint: a point is inside iff the number of crossings is *odd*.
//!
//! # What step 5 reports
//! A point with D = 0 in the half-open x-range l ≤ p < r of an edge is on the edge. The paper does not consider this
//! case; the test returns an error. Not all points on boundaries are reported. On a vertical edge, and on a vertex that
//! is no edge's left end, the test returns without an error; its answer is then that for the point moved to the right.
//!
//! # What Simulation of Simplicity makes of it
//! The perturbation x_i → x_i + ε^(2^i) moves a query that is numbered before all vertices of the map further than
//! them, and further to the right than up. So l ≤ p < r is that query's order, edge by edge, and wherever step 5 has no
//! error both codes give the same answer, on boundaries too. For a query that is numbered last the vertices move
//! instead, and the order is l < p ≤ r. Then the answers are equal if the query is not on a boundary.
//!
//! # In four forms
//! [`crosses`] is the test of one edge. [`locate`] visits all edges of all regions and shares nothing else with this
//! module. [`LocateIndex::locate_specially`] and [`LocateIndex::question_specially`] share the broad phase and the sums
//! with the generic code, and nothing else: they serve to compare speed.

use predicament_mesh::{PolygonMap, Region};
use predicament_predicates::{Plane, Scene, Sign, Vertex};

use super::single::Mark;
use super::{LocateIndex, Location, Scratch};

/// A point in the plane.
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

/// Returns true if the ray up from `p` crosses an edge, given by both ends in either order.
///
/// `sign_of_d` is called for l, r and p, with l left of r, in step 4 only. It must return the exact sign of
///
/// ```text
///     | l.x  l.y  1 |
/// D = | r.x  r.y  1 |
///     | p.x  p.y  1 |
/// ```
///
/// which is negative if p is below the edge.
///
/// # Errors
/// [`OnEdge`] if D is zero.
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

/// For each region, true if `p` is inside it; every edge is tested.
///
/// An edge that a region uses an even number of times bounds nothing: a point on it is not on the region's boundary.
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
    /// Locates `p`, for all regions in one pass, by the paper's own test; a region whose edge has the error of step 5
    /// is in `boundary`.
    ///
    /// The edges near `p` are those of [`locate`](LocateIndex::locate). D is computed, as there, only if the box of the
    /// edge holds `p`.
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
        assert!(x.is_finite() && y.is_finite(), "[{x}, {y}] is not a point: coordinates must be finite");
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

    /// Locates by the paper's own test of every edge that is not below the vertex `q`, as in
    /// [`question`](LocateIndex::question). D is computed wherever the paper's test needs it, and boxes decide nothing.
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

/// The sign of D for a point above or below both ends, without arithmetic.
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
