//! Overlay of a result with another polygon: parts that are far from the other polygon are not processed.
//!
//! The edges of a result meet in vertices only. So edges that are [certainly apart](super::sides) from the other
//! polygon's edges meet nothing, and do not change:
//! * A region whose box is off the other's is in the new result as a whole, or not at all.
//! * In the other regions, consecutive edges that are apart form a [`Run`]: one piece of the arrangement, which nothing
//!   divides. At its ends it has the directions of its first and its last edge.
//!
//! The leftmost vertex of each loop is needed to find the face around its component; in vertices of several loops the
//! loops touch. The edges at these vertices are not part of a run.

use predicament_predicates::{Predicates, Scene, Vertex};

use super::polygon::{Edge, Polygon, Region};
use super::reach::Extent;
use super::sides::{Known, Lines, NOTHING, Spot, joined, meets};

/// Consecutive edges of a loop that meet nothing else.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Run {
    /// Two or more edges, in the order of the loop.
    pub edges: Vec<Edge>,
    /// The operand whose edges they are: 0 or 1.
    pub operand: usize,
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

/// Divides a result by the edges of a polygon.
pub(super) fn split(session: &dyn Predicates, known: &mut Known, first: &[Region], second: &Polygon) -> Split {
    let lines = Lines::new(session, second);
    let mut split = Split::default();
    let touched = Touched::new(session.scene(), first);
    let mut chart = Chart::new(session, known);
    let mut is_near = Vec::new();
    for region in first {
        if !meets(&chart.enter(&region.outer), &lines.bounds) {
            split.apart.push(region.clone());
            continue;
        }
        for (at, one) in region.loops().enumerate() {
            if at > 0 {
                chart.enter(one);
            }
            is_near.clear();
            chart.keep_near(&lines, &mut is_near);
            for at in (0..one.len()).filter(|&at| touched.times(one[at].from) > 1) {
                keep_both(at, &mut is_near);
            }
            split.add(one, &is_near, 0);
        }
    }
    split
}

/// The positions of a loop's vertices.
struct Chart<'a> {
    session: &'a dyn Predicates,
    known: &'a mut Known,
    /// The points of the scene if it has nothing else; then positions are points.
    points: Option<&'a [[f64; 2]]>,
    at: Vec<[f64; 2]>,
    spots: Vec<Spot>,
}

impl<'a> Chart<'a> {
    fn new(session: &'a dyn Predicates, known: &'a mut Known) -> Chart<'a> {
        let scene = session.scene();
        let points = scene.constructions().is_empty().then(|| scene.coordinates().as_chunks().0);
        Chart { session, known, points, at: Vec::new(), spots: Vec::new() }
    }

    /// Enters a loop; returns its box.
    fn enter(&mut self, one: &[Edge]) -> Extent {
        self.at.clear();
        self.spots.clear();
        match self.points {
            Some(points) => {
                self.at.extend(one.iter().map(|edge| points[edge.from.index()]));
                self.at.iter().fold(NOTHING, |all, &[x, y]| joined(all, [x, y, x, y]))
            }
            None => {
                let Chart { session, known, .. } = self;
                self.spots.extend(one.iter().map(|edge| known.spot(*session, edge.from)));
                self.spots.iter().map(|spot| spot.extent).fold(NOTHING, joined)
            }
        }
    }

    /// Finds the edges of the loop that may meet the lines, and those at every vertex that may be leftmost.
    fn keep_near(&self, lines: &Lines, is_near: &mut Vec<bool>) {
        let less = |x: f64, y: f64| if y < x { y } else { x };
        if self.points.is_some() {
            lines.near_edges(&self.at, is_near);
            let least = self.at.iter().map(|at| at[0]).fold(f64::INFINITY, less);
            let lowest = self.at.iter().enumerate().filter(|(_, point)| point[0] <= least);
            lowest.for_each(|(at, _)| keep_both(at, is_near));
        } else {
            lines.near_between(&self.spots, is_near);
            let least = self.spots.iter().map(|spot| spot.extent[2]).fold(f64::INFINITY, less);
            let lowest = self.spots.iter().enumerate().filter(|(_, spot)| spot.extent[0] <= least);
            lowest.for_each(|(at, _)| keep_both(at, is_near));
        }
    }
}

/// Keeps the edges at a vertex.
pub(super) fn keep_both(at: usize, is_near: &mut [bool]) {
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
    /// Adds a loop of an operand: its edges, or runs of them.
    pub fn add(&mut self, one: &[Edge], is_near: &[bool], operand: usize) {
        // There is a leftmost vertex, with two edges.
        let start = is_near.iter().position(|is| *is).unwrap_or(0);
        // From there around the loop, in two parts; a run may be in both.
        let mut run: Vec<Edge> = Vec::new();
        for range in [start..one.len(), 0..start] {
            let mut at = range.start;
            while at < range.end {
                let far = is_near[at..range.end].iter().position(|is| *is).unwrap_or(range.end - at);
                run.extend_from_slice(&one[at..at + far]);
                at += far;
                if at < range.end {
                    self.end(&mut run, operand);
                    self.near.push(one[at]);
                    at += 1;
                }
            }
        }
        self.end(&mut run, operand);
    }

    fn end(&mut self, run: &mut Vec<Edge>, operand: usize) {
        if run.len() > 1 {
            self.runs.push(Run { edges: std::mem::take(run), operand });
        } else {
            self.near.append(run);
        }
    }
}
