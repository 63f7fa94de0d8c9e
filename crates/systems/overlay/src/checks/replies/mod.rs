//! Checks of Boolean operations on polygons that other programs compute, in doubles.
//!
//! A program's vertices are rounded, so its result is compared with the operands at a distance, `within`, which is that
//! of its farthest vertex from the operands' edges, and at least that of a few roundings.
//!
//! * `vertex off the operands`: each vertex is within that distance of an edge of an operand.
//! * `wrong set`: a point that is farther than that from all edges of the operands is in the result if and only if the
//!   operation says so for its winding numbers in the operands.
//! * `overlapping polygons`: such a point is in one polygon of the result at most.
//! * `wrong area`: the area is that of the operation, up to the area of the operands' edges widened by the distance.
//! * `crossing edges`: no two edges of the result cross by more than the distance.
//!
//! # Why the distance is enough
//! Let the true result be R, and its boundary ∂R. It is a part of the operands' edges. Let each vertex of a program's
//! result be within δ of where it belongs. Then each edge is within δ of the edge that it stands for, because the
//! distance of two segments is largest at their ends. So the result differs from R only within δ of ∂R. That is all
//! that the checks demand: a set with that property passes them, however it was rounded.
//!
//! The points are taken from every cell between the heights of all vertices and crossings if the operands have few
//! edges: then each part of R, each hole, and each neck that is wider than 2δ has a point of its own, so that the
//! number of components and holes is right after closing what is thinner. Otherwise an even sample is taken: beside
//! edges on both sides, at several distances, and anywhere. Points on both sides of an edge also show the other
//! direction of the Hausdorff distance: where R ends, the result ends.
//!
//! The membership of a point is exact: points, operands and results are doubles. The farthest wrong point has a
//! distance from the operands' edges, by which the caller says if the result is rounded or wrong.

mod area;
mod edges;
mod points;

use rug::Rational;

pub use edges::Edges;

use crate::answer::Operation;
use area::{area_of_operation, area_of_rings};

/// The rings of the polygons of a result; the first of a polygon is the outer one.
pub type Rings = Vec<Vec<Vec<[f64; 2]>>>;

/// The names of the checks.
pub const OFF: &str = "vertex off the operands";
/// The check of points.
pub const SET: &str = "wrong set";
/// The check of overlaps.
pub const OVERLAP: &str = "overlapping polygons";
/// The check of areas.
pub const AREA: &str = "wrong area";
/// The check of crossings.
pub const CROSSING: &str = "crossing edges";

/// The largest number of edges of both operands for which areas are computed and every cell has a point.
const FEW: usize = 160;

/// Two operands, and points whose membership is known.
pub struct Operands {
    /// The edges of each operand.
    edges: [Edges; 2],
    /// The edges of both, for distances.
    both: Edges,
    /// The rule for the inside of both.
    inside: fn(i32) -> bool,
    /// The length of all edges.
    length: f64,
}

/// A point with true for each operand that contains it.
pub type Witness = ([f64; 2], [bool; 2]);

/// A violation of a law.
#[derive(Clone, PartialEq, Debug)]
pub struct Violation {
    /// The name of the check.
    pub check: &'static str,
    /// The first place, in words.
    pub what: String,
    /// The distance from the operands' edges that explains it; `None` if no distance does.
    pub distance: Option<f64>,
}

impl Operands {
    /// Two operands by their loops, and the rule for winding numbers of inner points.
    #[must_use]
    pub fn new(loops: [&[Vec<[f64; 2]>]; 2], inside: fn(i32) -> bool) -> Operands {
        let both = Edges::new(loops.into_iter().flatten());
        let edges = loops.map(|loops| Edges::new(loops.iter()));
        let length = both.all().iter().map(|[a, b]| (a[0] - b[0]).hypot(a[1] - b[1])).sum();
        Operands { edges, both, inside, length }
    }

    /// The number of edges.
    #[must_use]
    pub fn len(&self) -> usize {
        self.both.all().len()
    }

    /// True if there are no edges.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The largest distance of a vertex of the result from the edges of the operands; zero without vertices.
    #[must_use]
    pub fn farthest(&self, result: &Rings, nearest: f64) -> f64 {
        let vertices = result.iter().flatten().flatten();
        vertices.map(|&p| self.both.distance(p, nearest)).fold(0.0, f64::max)
    }

    /// For each operand, true if a point is inside; `None` if it is on an edge.
    fn membership(&self, p: [f64; 2]) -> Option<[bool; 2]> {
        let [a, b] = &self.edges;
        Some([(self.inside)(a.winding(p)?), (self.inside)(b.winding(p)?)])
    }

    /// Points for [`violations`](Operands::violations): at most `most`, each farther than `within` from all edges, with
    /// its membership in both operands. Some of them are farther than `coarsest`.
    #[must_use]
    pub fn witnesses(&self, [within, coarsest]: [f64; 2], most: usize) -> Vec<Witness> {
        let all = self.both.all();
        self.known(points::candidates(all, [within, coarsest], self.len() <= FEW, most), within, most)
    }

    /// The memberships of candidates that are farther than `within` from all edges.
    fn known(&self, candidates: Vec<[f64; 2]>, within: f64, most: usize) -> Vec<Witness> {
        let step = candidates.len().div_ceil(most.max(1)).max(1);
        let far = |p: &[f64; 2]| !self.both.is_within(*p, within);
        let sampled = candidates.into_iter().step_by(step).filter(far);
        sampled.filter_map(|p| Some((p, self.membership(p)?))).collect()
    }

    /// The laws that the result of an operation violates at this distance; `crossed` is the number of edges that are
    /// compared with those near them.
    #[must_use]
    pub fn violations(
        &self,
        operation: Operation,
        result: &Rings,
        [within, coarsest]: [f64; 2],
        witnesses: &[Witness],
        crossed: usize,
    ) -> Vec<Violation> {
        let mut found = Vec::new();
        let polygons: Vec<Edges> = result.iter().map(|rings| Edges::new(rings.iter())).collect();
        let (mut wrong, mut twice) = ((0, None, 0.0_f64), (0, None));
        // Edges that the result has and should not have are found beside them.
        let edges = Edges::new(result.iter().flatten());
        let most = witnesses.len().max(64);
        let own = self.known(points::candidates(edges.all(), [within, coarsest], false, most), within, most);
        let count_of_points = witnesses.len() + own.len();
        for &(p, inside) in witnesses.iter().chain(&own) {
            let parities = polygons.iter().map(|polygon| polygon.winding(p).map(|winding| winding % 2 != 0));
            // A point on an edge between two polygons of the result is in the set that they cover.
            let Some(inside_of) = parities.collect::<Option<Vec<bool>>>() else { continue };
            let count = inside_of.into_iter().filter(|is| *is).count();
            if (count > 0) != operation.holds(inside) {
                let distance = self.both.distance(p, within);
                let is_worse = wrong.1.is_none() || distance > wrong.2;
                let first = if is_worse { Some((p, count > 0)) } else { wrong.1 };
                wrong = (wrong.0 + 1, first, wrong.2.max(distance));
            } else if count > 1 {
                twice = (twice.0 + 1, twice.1.or(Some((p, true))));
            }
        }
        if let (count, Some((p, is_in)), distance) = wrong {
            let [is, should] = if is_in { ["in", "not be"] } else { ["not in", "be"] };
            let what = format!("{p:?} is {is} the result and should {should}; {count} of {count_of_points} points");
            found.push(Violation { check: SET, what, distance: Some(distance) });
        }
        if let (count, Some((p, _))) = twice {
            let what = format!("{p:?} is in several polygons; {count} of {count_of_points} points");
            found.push(Violation { check: OVERLAP, what, distance: None });
        }
        found.extend(self.area(operation, result, within));
        if let Some(what) = edges.crossing(within, crossed) {
            found.push(Violation { check: CROSSING, what, distance: None });
        }
        found
    }

    /// Checks the area.
    fn area(&self, operation: Operation, result: &Rings, within: f64) -> Option<Violation> {
        if self.len() > FEW {
            return None;
        }
        let truth = area_of_operation([self.edges[0].all(), self.edges[1].all()], self.inside, operation);
        let edges = Edges::new(result.iter().flatten());
        // Strip by strip, a ring counts that passes through a vertex twice, with lobes of opposite directions.
        let area = if edges.all().len() <= FEW {
            area_of_operation([edges.all(), &[]], |winding| winding % 2 != 0, Operation::Union)
        } else {
            area_of_rings(result)
        };
        let off = Rational::from(&area - &truth).abs().to_f64() / 2.0;
        let corners = u32::try_from(2 * self.len()).map_or(f64::INFINITY, f64::from);
        // Both sides of each edge, and a disc around each end.
        let allowed = 2.0 * self.length * within + corners * 4.0 * within * within;
        (off > allowed * (1.0 + 1e-9)).then(|| {
            let [area, truth] = [area, truth].map(|twice| twice.to_f64() / 2.0);
            let what =
                format!("the area is {area:e}, expected {truth:e}; rounding explains a difference of {allowed:.1e}");
            Violation { check: AREA, what, distance: Some(off / (2.0 * self.length)) }
        })
    }
}
