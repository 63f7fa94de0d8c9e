//! How far edges reach on their segments, for the broad phase: most of what crosses beyond is nothing.
//!
//! Results of results have edges that are small parts of the input segments they are on. All pairs of these may cross and hardly
//! any of the edges. So the broad phase is given the edges, each as a part of its segment, and their boxes.
//!
//! # Why nothing is missed
//! Where a constructed vertex is, is estimated with an error bound. The box of a part is made larger by the bound, and no larger
//! than the segment's. Of the part itself each end is within the bound of where an edge ends, so that each point of the
//! edges is within the bound of the part; a bound that is not far below what the grid allows for ([`MOST`]) is not used:
//! then the part is the whole segment.

use predicament_predicates::{Construction, Plane, Predicates, Vertex};

use super::polygon::Edge;
use super::supports::Supports;
use crate::algorithm::snap::crossing_estimate;

/// Low x and y, high x and y.
pub(super) type Extent = [f64; 4];

/// The largest error of an end, as a part of the segment's extent: far below a thousandth of one of 4,096 cells.
const MOST: f64 = 1.0 / 1_073_741_824.0;

/// Parts of segments, several of one segment where its edges are apart.
pub(super) struct Reach {
    /// By their ends, within rounding.
    pub raw: Vec<[[f64; 2]; 2]>,
    /// Boxes that hold them.
    pub boxes: Vec<Extent>,
    /// The segment of each, ascending.
    pub segments: Vec<u32>,
}

impl Reach {
    /// The parts that edges pass.
    pub fn new(session: &dyn Predicates, supports: &Supports) -> Reach {
        let scene = session.scene();
        let count = supports.ends.len();
        let mut reach = Reach {
            raw: Vec::with_capacity(count),
            boxes: Vec::with_capacity(count),
            segments: Vec::with_capacity(count),
        };
        for (segment, ends) in (0..).zip(&supports.ends) {
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

#[inline]
fn extent([a, b]: &[[f64; 2]; 2]) -> Extent {
    [a[0].min(b[0]), a[1].min(b[1]), a[0].max(b[0]), a[1].max(b[1])]
}

/// An edge by its ends, and its box; none where these are not known well enough.
fn part(session: &dyn Predicates, edge: [Vertex; 2], whole: [[f64; 2]; 2]) -> Option<([[f64; 2]; 2], Extent)> {
    let outer = extent(&whole);
    let size = (outer[2] - outer[0]).max(outer[3] - outer[1]);
    let [(a, wrong), (b, also)] = [place(session, edge[0])?, place(session, edge[1])?];
    // Not a number, where lines are parallel or nearly so.
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

/// A box that holds an edge.
pub(super) fn edge_extent(session: &dyn Predicates, edge: Edge) -> Extent {
    let scene = session.scene();
    let whole = edge.support.map(|v| scene.point2(Plane::Xy, v));
    if [edge.from, edge.to] == edge.support {
        return extent(&whole);
    }
    part(session, [edge.from, edge.to], whole).map_or_else(|| extent(&whole), |(_, extent)| extent)
}

/// The ends of an edge within rounding, or else those of its segment.
pub(super) fn edge_raw(session: &dyn Predicates, edge: Edge) -> [[f64; 2]; 2] {
    let whole = edge.support.map(|v| session.scene().point2(Plane::Xy, v));
    part(session, [edge.from, edge.to], whole).map_or(whole, |(raw, _)| raw)
}

/// From where to where the x of a vertex can be.
pub(super) fn range(session: &dyn Predicates, v: Vertex) -> [f64; 2] {
    match place(session, v) {
        Some(([x, _], [error, _])) if x.is_finite() && error.is_finite() => {
            [(x - error).next_down(), (x + error).next_up()]
        }
        _ => [f64::NEG_INFINITY, f64::INFINITY],
    }
}

/// Where a vertex is, and by how much that may be wrong along each axis.
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
