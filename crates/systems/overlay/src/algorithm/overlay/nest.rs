//! The order of edges around nodes, and the faces that contain components.
//!
//! Directions are those of the input segments. The order of two edges around a node is the side of an input vertex on
//! the line of an input segment, even if the node is constructed.
//!
//! A component lies completely to the right of its leftmost node (the lowest of these). A vertical line a little left
//! of the node meets pieces above it. The face just left of the node is the face below the lowest of these pieces.

use std::ops::Range;

use predicament_grid::{Raster, parallel};
use predicament_mesh::{Nesting, Subdivision};
use predicament_predicates::{Axis, Plane, Predicates, Sign, Vertex};

use super::chains::Chains;
use super::far::Run;
use super::polygon::Edge;
use super::reach::{Reach, edge_raw, place};
use super::supports::Supports;
use super::view::View;
use super::{NONE, number};
use predicament_grid::sort::sort_by_sign;

/// The number of nodes whose half-edges are sorted together.
const BATCH: usize = 256;

/// The pieces in the plane.
pub(super) struct Pieces<'a> {
    pub view: View<'a>,
    pub supports: &'a Supports,
    pub chains: &'a Chains,
    /// For each segment, true if it goes to the right, or straight up.
    pub is_ahead: Vec<bool>,
    /// The directions in which each run leaves its ends: a segment, and true if it goes to the right or straight up.
    runs: Vec<[Direction; 2]>,
}

/// The ends of a segment in a direction, and true if that is to the right or straight up.
type Direction = ([Vertex; 2], bool);

/// A piece, or an edge of a run, that a vertical line meets.
#[derive(Clone, Copy)]
struct Above {
    piece: u32,
    /// True if the piece goes from left to right there.
    is_ahead: bool,
    /// The ends of its segment, and its own ends, from left to right.
    ends: [Vertex; 2],
    nodes: [Vertex; 2],
}

impl<'a> Pieces<'a> {
    pub fn new(session: &'a dyn Predicates, supports: &'a Supports, chains: &'a Chains) -> Pieces<'a> {
        let view = View::new(session);
        let is_ahead = |range: Range<usize>| -> Vec<bool> {
            supports.ends[range].iter().map(|&[a, b]| view.is_ahead(a, b)).collect()
        };
        let is_ahead = parallel::joined(parallel::ranges(supports.ends.len(), &is_ahead));
        let along = |from: Vertex, to: Vertex, [a, b]: [Vertex; 2]| {
            let [a, b] = if view.along([a, b]).order(from, to) == Sign::Positive { [b, a] } else { [a, b] };
            ([a, b], view.is_ahead(a, b))
        };
        let directions = |run: &Run| {
            let [first, last] = [run.edges[0], run.edges[run.edges.len() - 1]];
            [along(first.from, first.to, first.support), along(last.to, last.from, last.support)]
        };
        let runs = chains.runs.iter().map(directions).collect();
        Pieces { view, supports, chains, is_ahead, runs }
    }

    /// The ends of the segment of a half-edge, in its direction, and true if that is to the right or straight up.
    #[inline]
    pub fn direction(&self, half: u32) -> Direction {
        let piece = half as usize / 2;
        let segment = self.chains.pieces[piece].segment as usize;
        if segment == NONE as usize {
            return self.runs[piece - (self.chains.pieces.len() - self.runs.len())][half as usize % 2];
        }
        let [a, b] = self.supports.ends[segment];
        let is_ahead = self.is_ahead[segment];
        if half.is_multiple_of(2) { ([a, b], is_ahead) } else { ([b, a], !is_ahead) }
    }

    /// The counterclockwise order of two half-edges that leave one node, starting from straight down.
    fn order_around(&self, a: u32, b: u32) -> Sign {
        let ([from, to], a_is_ahead) = self.direction(a);
        let ([_, other], b_is_ahead) = self.direction(b);
        match (a_is_ahead, b_is_ahead) {
            (true, false) => Sign::Negative,
            (false, true) => Sign::Positive,
            _ => -self.view.turn(from, to, other),
        }
    }

    /// Builds the subdivision: nodes, pieces and their order around nodes.
    pub fn subdivision(&self) -> Subdivision {
        let ends = self.chains.pieces.iter().map(|piece| piece.ends).collect();
        Subdivision::new(self.chains.nodes.len(), ends, &|node, first, halves| self.sort_around(node, first, halves))
    }

    /// Sorts the half-edges around nodes: around crossings of two segments by one turn each, which is known, or asked
    /// in batches.
    fn sort_around(&self, node: usize, first: &[u32], halves: &mut [u32]) {
        let mut signs = [Sign::Zero; BATCH];
        let (mut queries, mut crossings) = (Vec::new(), Vec::new());
        for start in (0..first.len() - 1).step_by(BATCH) {
            queries.clear();
            crossings.clear();
            for (at, ends) in first[start..first.len().min(start + BATCH + 1)].windows(2).enumerate() {
                let own = &mut halves[ends[0] as usize..ends[1] as usize];
                if own.len() < 3 {
                    continue;
                }
                let known = self.chains.crossings.get((node + start + at).wrapping_sub(self.chains.inputs));
                if let (Some(crossing), &mut [a, b, c, d]) = (known, &mut *own) {
                    let [is_ahead, other] = crossing.pair().map(|segment| self.is_ahead[segment as usize]);
                    let halves = ahead_first([a, b, c, d], [is_ahead, other]);
                    own.copy_from_slice(&around(halves, crossing.is_leftward() == (is_ahead == other)));
                } else if let Some((sorted, query)) = self.crossing(own) {
                    queries.push(query);
                    crossings.push((ends[0] as usize, sorted));
                } else {
                    sort_by_sign(own, |a, b| self.order_around(a, b));
                }
            }
            if queries.is_empty() {
                continue;
            }
            self.view.session.orient2d_batch(Plane::Xy, &queries, &mut signs[..queries.len()]);
            for (&(at, sorted), sign) in crossings.iter().zip(signs) {
                let own = &mut halves[at..at + 4];
                match sign {
                    Sign::Zero => sort_by_sign(own, |a, b| self.order_around(a, b)),
                    sign => own.copy_from_slice(&around(sorted, sign == Sign::Positive)),
                }
            }
        }
    }

    /// The half-edges around a crossing of two segments: those ahead, then those back; of the first segment, then of
    /// the other. And the turn from the first to the second. `None` if they are something else.
    fn crossing(&self, halves: &[u32]) -> Option<([u32; 4], [Vertex; 3])> {
        let &[a, b, c, d] = halves else { return None };
        let segment = |half: u32| self.chains.pieces[half as usize / 2].segment;
        let [first, second] = [segment(a), segment(c)];
        // On each segment, back and forth.
        let is_through = |[back, forth]: [u32; 2]| back % 2 == 1 && forth.is_multiple_of(2);
        let are_through = is_through([a, b]) && is_through([c, d]);
        if !are_through || segment(b) != first || segment(d) != second {
            return None;
        }
        // A run has no segment, and the same segment twice has no other end.
        let [mut from, mut to] = *self.supports.ends.get(first as usize)?;
        let ends = self.supports.ends.get(second as usize)?;
        let are_ahead = [first, second].map(|segment| self.is_ahead[segment as usize]);
        if !are_ahead[0] {
            (from, to) = (to, from);
        }
        let other = ends[usize::from(are_ahead[1])];
        (other != from && other != to).then_some((ahead_first([a, b, c, d], are_ahead), [from, to, other]))
    }

    fn vertex(&self, node: u32) -> Vertex {
        self.chains.nodes[node as usize]
    }

    /// The location of each component with edges, from left to right by their leftmost nodes.
    pub fn nestings(&self, subdivision: &Subdivision, raster: Option<Raster>, reach: &Reach) -> Vec<Nesting> {
        // A crossing is right of an end of both its segments, so it is never leftmost, unless edges are parts of
        // segments.
        let candidates = if self.supports.are_whole { self.chains.inputs } else { self.chains.nodes.len() };
        let mut leftmost = vec![NONE; subdivision.components()];
        for node in 0..number(candidates) {
            let best = &mut leftmost[subdivision.component(node) as usize];
            if *best == NONE || self.view.order(self.vertex(node), self.vertex(*best)) == Sign::Negative {
                *best = node;
            }
        }
        leftmost.retain(|&node| !subdivision.leaving(node).is_empty());
        sort_by_sign(&mut leftmost, |a, b| self.view.order(self.vertex(a), self.vertex(b)));
        let outside = |node: u32| {
            let halves = subdivision.leaving(node).iter().copied();
            // The last half-edge counterclockwise has all others on its right, and the outside on its left.
            halves.reduce(|last, half| if self.order_around(last, half) == Sign::Negative { half } else { last })
        };
        if leftmost.len() < 2 {
            let outside = leftmost.iter().filter_map(|&node| outside(node));
            return outside.map(|outside| Nesting { outside, within: None }).collect();
        }
        let runs: Vec<(usize, Edge)> =
            (0..).zip(&self.chains.runs).flat_map(|(at, run)| run.edges.iter().map(move |&edge| (at, edge))).collect();
        let raster = raster.filter(|_| runs.is_empty()).unwrap_or_else(|| {
            let far = runs.iter().map(|&(_, edge)| edge_raw(self.view.session, edge));
            Raster::new(&reach.raw.iter().copied().chain(far).collect::<Vec<_>>())
        });
        let nestings = |range: Range<usize>| -> Vec<Nesting> {
            let seen = vec![NONE; self.supports.ends.len() + runs.len()];
            let mut rays = Rays { pieces: self, reach, runs: &runs, seen, sorted: Vec::new() };
            let nesting = |&node: &u32| {
                let outside = outside(node)?;
                Some(Nesting { outside, within: rays.above(&raster, node) })
            };
            leftmost[range].iter().filter_map(nesting).collect()
        };
        parallel::joined(parallel::ranges(leftmost.len(), &nestings))
    }

    /// The part of a segment that a vertical line, a little left of a vertex, meets above the vertex.
    fn meet(&self, segment: u32, from: Vertex) -> Option<Above> {
        let is_past = |v: Vertex| self.view.compare(Axis::X, v, from) == Sign::Negative;
        let [a, b] = self.supports.ends[segment as usize];
        let past = [is_past(a), is_past(b)];
        if past[0] == past[1] {
            return None;
        }
        let ends = if past[0] { [a, b] } else { [b, a] };
        if self.view.turn(ends[0], ends[1], from) != Sign::Negative {
            return None;
        }
        let range = self.chains.of(segment as usize);
        let along = &self.chains.along[range.clone()];
        // The first node on the other side of the line.
        let at = along.partition_point(|&node| is_past(self.vertex(node)) == past[0]);
        let place = range.start + at.checked_sub(1)?;
        let piece = self.chains.piece[place];
        if piece == NONE {
            return None;
        }
        let [u, v] = [along[at - 1], *along.get(at)?];
        let nodes = if past[0] { [u, v] } else { [v, u] };
        let is_ahead = self.chains.pieces[piece as usize].ends[0] == nodes[0];
        Some(Above { piece, is_ahead, ends, nodes: nodes.map(|node| self.vertex(node)) })
    }

    /// An edge of a run, if a vertical line a little left of a vertex meets it above the vertex.
    fn meet_run(&self, run: usize, edge: Edge, from: Vertex) -> Option<Above> {
        let is_past = |v: Vertex| self.view.compare(Axis::X, v, from) == Sign::Negative;
        let is_ahead = is_past(edge.from);
        if is_ahead == is_past(edge.to) {
            return None;
        }
        let nodes = if is_ahead { [edge.from, edge.to] } else { [edge.to, edge.from] };
        let [a, b] = edge.support;
        let ends = if self.view.order(a, b) == Sign::Negative { [a, b] } else { [b, a] };
        if self.view.turn(ends[0], ends[1], from) != Sign::Negative {
            return None;
        }
        let piece = number(self.chains.pieces.len() - self.chains.runs.len() + run);
        Some(Above { piece, is_ahead, ends, nodes })
    }

    /// True if piece `a` is below piece `b` where a vertical line meets both.
    fn is_below(&self, a: &Above, b: &Above) -> bool {
        let [left, other] = [a.nodes[0], b.nodes[0]];
        if left == other {
            return self.view.turn(b.ends[0], b.ends[1], a.ends[1]) == Sign::Negative;
        }
        if self.view.order(left, other) == Sign::Negative {
            self.view.turn(a.ends[0], a.ends[1], other) == Sign::Positive
        } else {
            self.view.turn(b.ends[0], b.ends[1], left) == Sign::Negative
        }
    }
}

/// Half-edges around a crossing, given those back and forth on each segment: those ahead, then those back.
#[inline]
fn ahead_first([a, b, c, d]: [u32; 4], are_ahead: [bool; 2]) -> [u32; 4] {
    let [back, ahead] = if are_ahead[0] { [a, b] } else { [b, a] };
    let [also_back, also_ahead] = if are_ahead[1] { [c, d] } else { [d, c] };
    [ahead, also_ahead, back, also_back]
}

/// The counterclockwise order of these half-edges, from straight down; `is_left` if the second is left of the first.
#[inline]
fn around([a, b, back, also]: [u32; 4], is_left: bool) -> [u32; 4] {
    if is_left { [a, b, back, also] } else { [b, a, also, back] }
}

/// Upward rays to find the piece above a node.
struct Rays<'a> {
    pieces: &'a Pieces<'a>,
    reach: &'a Reach,
    /// The edges of runs, each with the index of its run.
    runs: &'a [(usize, Edge)],
    /// For each segment and each edge of a run, the last node for which it was tested.
    seen: Vec<u32>,
    /// Ends of segments from left to right, computed on demand.
    sorted: Vec<Vertex>,
}

impl Rays<'_> {
    /// The half-edge on the boundary of the face just left of a node, with that face on its left.
    fn above(&mut self, raster: &Raster, node: u32) -> Option<u32> {
        let pieces = self.pieces;
        let scene = pieces.view.session.scene();
        let from = pieces.vertex(node);
        let (columns, y) = match from.construction() {
            None => {
                let [x, y] = scene.point2(Plane::Xy, from);
                ([x, x], y)
            }
            Some(_) => match place(pieces.view.session, from) {
                Some(([x, y], error)) if error.iter().all(|error| error.is_finite()) => {
                    ([(x - error[0]).next_down(), (x + error[0]).next_up()], (y - error[1]).next_down())
                }
                _ => (self.columns(from), f64::MIN),
            },
        };
        let mut best: Option<(Above, usize)> = None;
        raster.upward(columns, y, |parts, row| {
            for &part in parts {
                // Parts of segments, then edges of runs.
                let part = part as usize;
                let far = part.checked_sub(self.reach.segments.len());
                let place =
                    far.map_or_else(|| self.reach.segments[part] as usize, |far| pieces.supports.ends.len() + far);
                if std::mem::replace(&mut self.seen[place], node) == node {
                    continue;
                }
                let met = match far.map(|far| self.runs[far]) {
                    None => pieces.meet(number(place), from),
                    Some((run, edge)) => pieces.meet_run(run, edge, from),
                };
                let Some(above) = met else { continue };
                if best.as_ref().is_none_or(|(best, _)| pieces.is_below(&above, best)) {
                    let top = above.ends.map(|v| scene.point2(Plane::Xy, v)[1]);
                    best = Some((above, raster.last_row(top[0].max(top[1]))));
                }
            }
            // Later candidates are completely above it.
            best.as_ref().is_some_and(|&(_, last)| last <= row)
        });
        let (above, _) = best?;
        // It goes to the left, so the region below is on its left.
        Some(2 * above.piece + u32::from(above.is_ahead))
    }

    /// An interval of raw x-coordinates that contains a constructed vertex.
    fn columns(&mut self, v: Vertex) -> [f64; 2] {
        let scene = self.pieces.view.session.scene();
        let x = |v: Vertex| scene.coordinate(Axis::X, v);
        if self.sorted.is_empty() {
            self.sorted = self.pieces.supports.ends.as_flattened().to_vec();
            self.sorted.sort_unstable_by(|&a, &b| x(a).total_cmp(&x(b)));
        }
        let sorted = &self.sorted;
        let right = sorted.partition_point(|&end| self.pieces.view.compare(Axis::X, end, v) == Sign::Negative);
        let end = |at: Option<usize>| at.and_then(|at| sorted.get(at)).map(|&end| x(end));
        [end(right.checked_sub(1)).unwrap_or(f64::MIN), end(Some(right)).unwrap_or(f64::MAX)]
    }
}
