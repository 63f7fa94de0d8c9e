//! Overlay of a result with another polygon: parts that are far from the other polygon are not processed.
//!
//! The edges of a result meet in vertices only. So edges outside the other polygon's box meet nothing, and do not
//! change:
//! * A region whose box is off the other's is in the new result as a whole, or not at all.
//! * In the other regions, consecutive edges off the box form a [`Run`]: one piece of the arrangement, which nothing
//!   divides. At its ends it has the directions of its first and its last edge.
//!
//! The leftmost vertex of each loop is needed to find the face around its component; in vertices of several loops the
//! loops touch. The edges at these vertices are not part of a run.

use predicament_predicates::{Predicates, Scene, Vertex};

use super::polygon::{Edge, Polygon, Region};
use super::reach::{Extent, edge_extent, range};

/// Consecutive edges of a loop, off the other operand's box.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Run {
    /// Two or more edges, in the order of the loop.
    pub edges: Vec<Edge>,
}

impl Run {
    /// The first and the last vertex.
    pub fn ends(&self) -> [Vertex; 2] {
        [self.edges[0].from, self.edges[self.edges.len() - 1].to]
    }
}

/// A result, divided by the box of another polygon.
#[derive(Default)]
pub(super) struct Split {
    /// Edges to compare.
    pub near: Vec<Edge>,
    /// The rest of their loops.
    pub runs: Vec<Run>,
    /// Regions off the box.
    pub apart: Vec<Region>,
}

/// Divides a result by the box of a polygon.
pub(super) fn split(session: &dyn Predicates, first: &[Region], second: &Polygon) -> Split {
    const NOTHING: Extent = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    let joined =
        |all: Extent, one: Extent| [all[0].min(one[0]), all[1].min(one[1]), all[2].max(one[2]), all[3].max(one[3])];
    let reached = second.loops.iter().flatten().map(|edge| edge_extent(session, *edge)).fold(NOTHING, joined);
    let meets = |one: &Extent| {
        (one[0] <= reached[2]) & (reached[0] <= one[2]) & (one[1] <= reached[3]) & (reached[1] <= one[3])
    };
    let mut split = Split::default();
    let touched = Touched::new(session.scene(), first);
    let mut extents: Vec<Extent> = Vec::new();
    for region in first {
        extents.clear();
        extents.extend(region.outer.iter().map(|edge| edge_extent(session, *edge)));
        if !meets(&extents.iter().copied().fold(NOTHING, joined)) {
            split.apart.push(region.clone());
            continue;
        }
        for (at, one) in region.loops().enumerate() {
            if at > 0 {
                extents.clear();
                extents.extend(one.iter().map(|edge| edge_extent(session, *edge)));
            }
            let mut is_near: Vec<bool> = extents.iter().map(meets).collect();
            keep_leftmost(session, one, &mut is_near);
            for at in (0..one.len()).filter(|&at| touched.times(one[at].from) > 1) {
                keep_both(at, &mut is_near);
            }
            split.add(one, &is_near);
        }
    }
    split
}

/// Keeps the edges at every vertex that may be a loop's leftmost.
fn keep_leftmost(session: &dyn Predicates, one: &[Edge], is_near: &mut [bool]) {
    let ranges: Vec<[f64; 2]> = one.iter().map(|edge| range(session, edge.from)).collect();
    let least = ranges.iter().map(|range| range[1]).fold(f64::INFINITY, f64::min);
    for (at, _) in ranges.iter().enumerate().filter(|(_, range)| range[0] <= least) {
        keep_both(at, is_near);
    }
}

/// Keeps the edges at a vertex.
fn keep_both(at: usize, is_near: &mut [bool]) {
    is_near[at] = true;
    is_near[(at + is_near.len() - 1) % is_near.len()] = true;
}

/// The number of times that loops pass each vertex.
pub(super) struct Touched {
    inputs: usize,
    /// The number, capped at 2: zero, one, or more.
    times: Vec<u8>,
}

impl Touched {
    pub fn new(scene: &Scene, regions: &[Region]) -> Touched {
        let mut touched = Touched { inputs: scene.len(), times: vec![0; scene.len() + scene.constructions().len()] };
        for edge in regions.iter().flat_map(Region::loops).flatten() {
            let slot = touched.slot(edge.from);
            touched.times[slot] = (touched.times[slot] + 1).min(2);
        }
        touched
    }

    fn slot(&self, v: Vertex) -> usize {
        v.construction().map_or_else(|| v.index(), |index| self.inputs + index)
    }

    /// The number of times that loops pass a vertex; 2 means two or more.
    pub fn times(&self, v: Vertex) -> u8 {
        self.times[self.slot(v)]
    }
}

impl Split {
    /// Adds a loop: its edges, or runs of them.
    fn add(&mut self, one: &[Edge], is_near: &[bool]) {
        // There is a leftmost vertex, with two edges.
        let start = is_near.iter().position(|is| *is).unwrap_or(0);
        let mut run: Vec<Edge> = Vec::new();
        for step in 0..one.len() {
            let at = (start + step) % one.len();
            if is_near[at] {
                self.end(&mut run);
                self.near.push(one[at]);
            } else {
                run.push(one[at]);
            }
        }
        self.end(&mut run);
    }

    fn end(&mut self, run: &mut Vec<Edge>) {
        if run.len() > 1 {
            self.runs.push(Run { edges: std::mem::take(run) });
        } else {
            self.near.append(run);
        }
    }
}
