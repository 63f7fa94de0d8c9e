//! The reach of edges on their segments, for the broad phase: segments that cross outside their edges are not compared.
//!
//! Results of results have edges that are small parts of their input segments. All pairs of these segments may cross,
//! and hardly any of the edges. So the broad phase gets the edges, each as a part of its segment, and their boxes.
//!
//! # Why nothing is missed
//! The position of a constructed vertex is estimated with an error bound. The box of a part is enlarged by the bound,
//! but not beyond the segment's box. Each end of the part is within the bound of the edge's end, so each point of the
//! edges is within the bound of the part. If a bound is not far below the grid's tolerance ([`MOST`]), the estimate is
//! not used: then the part is the whole segment.

use std::ops::Range;

use predicament_grid::parallel;
use predicament_predicates::{Construction, Plane, Predicates, Vertex};

use super::polygon::Edge;
use super::supports::Supports;
use crate::algorithm::snap::crossing_estimate;

/// A box: low x, low y, high x, high y.
pub(super) type Extent = [f64; 4];

/// The maximum error of an end, as a fraction of the segment's extent: far below a thousandth of one of 4,096 cells.
const MOST: f64 = 1.0 / 1_073_741_824.0;

/// Parts of segments, several of one segment if its edges are apart.
pub(super) struct Reach {
    /// The ends of the parts, within rounding.
    pub raw: Vec<[[f64; 2]; 2]>,
    /// Boxes that contain the parts.
    pub boxes: Vec<Extent>,
    /// The segment of each part, ascending.
    pub segments: Vec<u32>,
}

impl Reach {
    /// Finds the parts that edges pass.
    pub fn new(session: &dyn Predicates, supports: &Supports) -> Reach {
        let parts = parallel::ranges(supports.ends.len(), &|range| Reach::some(session, supports, range));
        parts.joined(|reach, mut part| {
            reach.raw.append(&mut part.raw);
            reach.boxes.append(&mut part.boxes);
            reach.segments.append(&mut part.segments);
        })
    }

    /// Finds the parts of some segments.
    fn some(session: &dyn Predicates, supports: &Supports, segments: Range<usize>) -> Reach {
        let scene = session.scene();
        let count = segments.len();
        let mut reach = Reach {
            raw: Vec::with_capacity(count),
            boxes: Vec::with_capacity(count),
            segments: Vec::with_capacity(count),
        };
        for (segment, ends) in (super::number(segments.start)..).zip(&supports.ends[segments]) {
            let whole = ends.map(|v| scene.point2(Plane::Xy, v));
            if !supports.are_whole {
                let before = reach.raw.len();
                let spans = supports.spans(segment as usize);
                let all = spans.iter().all(|span| {
                    let part = part(session, [span.from, span.to], whole);
                    part.is_some_and(|(raw, extent)| {
                        reach.push(segment, raw, extent);
                        true
                    })
                });
                if all {
                    continue;
                }
                reach.truncate(before);
            }
            reach.push(segment, whole, extent(&whole));
        }
        reach
    }

    fn push(&mut self, segment: u32, raw: [[f64; 2]; 2], extent: Extent) {
        self.raw.push(raw);
        self.boxes.push(extent);
        self.segments.push(segment);
    }

    fn truncate(&mut self, count: usize) {
        self.raw.truncate(count);
        self.boxes.truncate(count);
        self.segments.truncate(count);
    }
}

/// The box of two points.
#[inline]
pub(super) fn extent([a, b]: &[[f64; 2]; 2]) -> Extent {
    [a[0].min(b[0]), a[1].min(b[1]), a[0].max(b[0]), a[1].max(b[1])]
}

/// An edge as its ends and its box; `None` if these are not known well enough.
fn part(session: &dyn Predicates, edge: [Vertex; 2], whole: [[f64; 2]; 2]) -> Option<([[f64; 2]; 2], Extent)> {
    let outer = extent(&whole);
    let size = (outer[2] - outer[0]).max(outer[3] - outer[1]);
    let [(a, wrong), (b, also)] = [place(session, edge[0])?, place(session, edge[1])?];
    // Not a number, if lines are parallel or nearly so.
    let is_known = |error: &f64| *error <= MOST * size;
    if !wrong.iter().chain(&also).all(is_known) || !a.iter().chain(&b).all(|x| x.is_finite()) {
        return None;
    }
    let mut bounds = outer;
    for i in 0..2 {
        let low = (a[i] - wrong[i]).min(b[i] - also[i]).next_down();
        let high = (a[i] + wrong[i]).max(b[i] + also[i]).next_up();
        bounds[i] = bounds[i].max(low);
        bounds[i + 2] = bounds[i + 2].min(high);
    }
    Some(([a, b], bounds))
}

/// A box that contains an edge.
pub(super) fn edge_extent(session: &dyn Predicates, edge: Edge) -> Extent {
    let scene = session.scene();
    let whole = edge.support.map(|v| scene.point2(Plane::Xy, v));
    if [edge.from, edge.to] == edge.support {
        return extent(&whole);
    }
    part(session, [edge.from, edge.to], whole).map_or_else(|| extent(&whole), |(_, extent)| extent)
}

/// The ends of an edge within rounding, otherwise the ends of its segment.
pub(super) fn edge_raw(session: &dyn Predicates, edge: Edge) -> [[f64; 2]; 2] {
    let whole = edge.support.map(|v| session.scene().point2(Plane::Xy, v));
    part(session, [edge.from, edge.to], whole).map_or(whole, |(raw, _)| raw)
}

/// The position of a vertex, and an error bound along each axis.
pub(super) fn place(session: &dyn Predicates, v: Vertex) -> Option<([f64; 2], [f64; 2])> {
    let scene = session.scene();
    if !v.is_constructed() {
        return Some((scene.point2(Plane::Xy, v), [0.0; 2]));
    }
    if let Some(rounded) = session.rounded_point(v) {
        return Some((<[f64; 2]>::try_from(rounded).ok().filter(|at| at.iter().all(|x| x.is_finite()))?, [0.0; 2]));
    }
    let Some(Construction::Ssi(lines)) = scene.construction(v) else { return None };
    if lines.as_flattened().iter().any(|v| v.is_constructed()) {
        return None;
    }
    let [e, f] = lines.map(|ends| ends.map(|v| scene.point2(Plane::Xy, v)));
    Some(crossing_estimate(e, f))
}
