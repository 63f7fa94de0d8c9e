//! Winding numbers of faces, and the regions of a result.

use predicament_mesh::Subdivision;
use predicament_predicates::{Predicates, Sign};

use super::chains::Piece;
use super::far::{Run, Touched};
use super::polygon::{Edge, Region, Rule};
use super::view::View;
use super::{Arrangement, Contradiction, NONE, reach};
use crate::answer::Operation;

/// The winding numbers of both operands in each face, starting at the unbounded face; and true if they agree around
/// every piece. With an even-odd rule they are 0 and 1, because edges that the operand passes an even number of times
/// are absent.
pub(super) fn windings(subdivision: &Subdivision, pieces: &[Piece], rules: [Rule; 2]) -> (Vec<[i32; 2]>, bool) {
    let mut windings = vec![[0; 2]; subdivision.faces().len()];
    let mut is_known = vec![false; windings.len()];
    is_known[0] = true;
    let mut open = vec![0_u32];
    while let Some(face) = open.pop() {
        let own = windings[face as usize];
        let cycles = &subdivision.faces()[face as usize];
        for &cycle in cycles.outer.iter().chain(&cycles.inner) {
            for half in subdivision.walk_from(subdivision.cycles()[cycle as usize]) {
                let other = subdivision.face(half ^ 1) as usize;
                if !is_known[other] {
                    is_known[other] = true;
                    windings[other] = across(own, pieces, half, rules);
                    open.push(u32::try_from(other).unwrap_or(NONE));
                }
            }
        }
    }
    let agrees = (0..).step_by(2).zip(pieces).all(|(half, _)| {
        let [left, right] = [half, half ^ 1].map(|half| windings[subdivision.face(half) as usize]);
        across(left, pieces, half, rules) == right
    });
    (windings, agrees && is_known.iter().all(|is| *is))
}

/// The winding numbers on the right of a half-edge, from those on its left.
fn across(left: [i32; 2], pieces: &[Piece], half: u32, rules: [Rule; 2]) -> [i32; 2] {
    let label = pieces[half as usize / 2].label;
    let sign = if half.is_multiple_of(2) { 1 } else { -1 };
    [0, 1].map(|operand: usize| {
        let winding = left[operand].wrapping_sub(sign * label[operand]);
        if rules[operand] == Rule::EvenOdd { winding.rem_euclid(2) } else { winding }
    })
}

/// The regions of a result, as far as they could be made, and the broken rule.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Regions {
    /// The regions, in the order of their outer loops.
    pub regions: Vec<Region>,
    /// The first rule that signs break; `None` if the result is complete.
    pub broken: Option<Contradiction>,
}

/// The extraction of regions from faces, some of which are inside.
pub(super) struct Extraction<'a> {
    pub view: View<'a>,
    pub arrangement: &'a Arrangement,
    pub windings: &'a [[i32; 2]],
    pub rules: [Rule; 2],
    /// Other regions of the result, which touch the extracted ones in vertices at most.
    pub apart: &'a [Region],
}

/// A loop with the region that it bounds.
struct Bound {
    region: u32,
    is_hole: bool,
    edges: Vec<Edge>,
}

impl Extraction<'_> {
    pub fn regions(&self, operation: Operation) -> Regions {
        let subdivision = &self.arrangement.subdivision;
        let is_inside: Vec<bool> = self
            .windings
            .iter()
            .map(|winding| operation.holds([0, 1].map(|at| self.rules[at].is_inside(winding[at]))))
            .collect();
        let halves = 2 * subdivision.edges().len();
        let inside = |half: usize| is_inside[subdivision.face(super::number(half)) as usize];
        let is_bound: Vec<bool> = (0..halves).map(|half| inside(half) && !inside(half ^ 1)).collect();
        let region = self.components(&is_inside);
        // Where several loops meet, each has a vertex.
        let mut bounds_at = vec![0_u32; subdivision.nodes()];
        (0..halves).filter(|&half| is_bound[half]).for_each(|half| {
            bounds_at[subdivision.origin(super::number(half)) as usize] += 1;
        });
        if !self.apart.is_empty() {
            let apart = Touched::new(self.view.session.scene(), self.apart);
            for (bounds, v) in bounds_at.iter_mut().zip(&self.arrangement.vertices) {
                *bounds += u32::from(apart.times(*v));
            }
        }
        let mut result = Regions::default();
        let mut bounds: Vec<Bound> = Vec::new();
        let mut is_done = vec![false; halves];
        let mut place = vec![NONE; subdivision.nodes()];
        for start in (0..halves).filter(|&half| is_bound[half]) {
            if is_done[start] {
                continue;
            }
            let walk = self.walk(start, &is_bound, &mut is_done);
            let region = region[subdivision.face(super::number(start)) as usize];
            for simple in simple_loops(subdivision, &walk, &mut place) {
                bounds.push(self.bound(&simple, region, &bounds_at));
            }
        }
        // A region's outer loop comes before its holes.
        bounds.sort_unstable_by(|a, b| {
            (a.region, a.is_hole).cmp(&(b.region, b.is_hole)).then_with(|| a.edges.cmp(&b.edges))
        });
        for group in bounds.chunk_by(|a, b| a.region == b.region) {
            let outer: Vec<&Bound> = group.iter().filter(|bound| !bound.is_hole).collect();
            let holes: Vec<Vec<Edge>> =
                group.iter().filter(|bound| bound.is_hole).map(|bound| bound.edges.clone()).collect();
            let [outer] = outer.as_slice() else {
                result.broken.get_or_insert(Contradiction::Outer);
                continue;
            };
            result.regions.push(Region { outer: outer.edges.clone(), holes });
        }
        result.regions.sort_unstable();
        result
    }

    /// The components of the inside: for each face, the lowest face that can be reached without leaving the inside.
    fn components(&self, is_inside: &[bool]) -> Vec<u32> {
        let subdivision = &self.arrangement.subdivision;
        let mut region = vec![NONE; is_inside.len()];
        let mut open = Vec::new();
        for (number, start) in (0..).zip(0..is_inside.len()) {
            if region[start] != NONE || !is_inside[start] {
                continue;
            }
            region[start] = number;
            open.push(start);
            while let Some(face) = open.pop() {
                let cycles = &subdivision.faces()[face];
                for &cycle in cycles.outer.iter().chain(&cycles.inner) {
                    for half in subdivision.walk_from(subdivision.cycles()[cycle as usize]) {
                        let other = subdivision.face(half ^ 1) as usize;
                        if is_inside[other] && region[other] == NONE {
                            region[other] = number;
                            open.push(other);
                        }
                    }
                }
            }
        }
        region
    }

    /// The half-edges of a bound in order, with the same part of the inside on their left.
    fn walk(&self, start: usize, is_bound: &[bool], is_done: &mut [bool]) -> Vec<u32> {
        let subdivision = &self.arrangement.subdivision;
        let mut walk = Vec::new();
        let mut at = super::number(start);
        while !std::mem::replace(&mut is_done[at as usize], true) {
            walk.push(at);
            // Clockwise through the inside, to the next bound. This ends at the latest at the incoming half-edge: its
            // other side is outside, so the half-edge before is a bound.
            at = subdivision.next(at);
            while !is_bound[at as usize] {
                at = subdivision.next(at ^ 1);
            }
        }
        walk
    }

    /// A simple loop in its final form.
    fn bound(&self, halves: &[u32], region: u32, bounds_at: &[u32]) -> Bound {
        let arrangement = self.arrangement;
        let mut edges: Vec<Edge> = Vec::with_capacity(halves.len());
        let edge = |half: u32| {
            let [from, to] =
                [half, half ^ 1].map(|half| arrangement.vertices[arrangement.subdivision.origin(half) as usize]);
            let segment = arrangement.subdivision_segment(half);
            Edge { from, to, support: segment }
        };
        let mut last = NONE;
        let same = |a: u32, b: u32| {
            let is_touched = bounds_at[arrangement.subdivision.origin(b) as usize] > 1;
            let line = |half: u32| (arrangement.pieces[half as usize / 2].segment, half % 2);
            !is_touched && a != NONE && line(a) == line(b) && line(a).0 != NONE
        };
        for &half in halves {
            if let Some(run) = arrangement.run(half) {
                if half.is_multiple_of(2) {
                    edges.extend(&run.edges);
                } else {
                    edges.extend(run.edges.iter().rev().map(|edge| edge.reversed()));
                }
            } else {
                match edges.last_mut() {
                    Some(before) if same(last, half) => before.to = edge(half).to,
                    _ => edges.push(edge(half)),
                }
            }
            last = half;
        }
        // The first half-edge may be in the middle of an edge.
        if edges.len() > 1 && same(last, halves[0]) {
            edges[0].from = edges[edges.len() - 1].from;
            edges.pop();
        }
        let first = (0..edges.len()).min_by_key(|&at| edges[at].from).unwrap_or(0);
        edges.rotate_left(first);
        Bound { region, is_hole: self.turn(&edges) == Sign::Negative, edges }
    }

    /// The orientation of a simple loop: the turn at its leftmost vertex.
    fn turn(&self, edges: &[Edge]) -> Sign {
        // Vertices that can be leftmost, by their approximate positions.
        let ranges: Vec<[f64; 2]> = edges.iter().map(|edge| reach::range(self.view.session, edge.from)).collect();
        let least = ranges.iter().map(|range| range[1]).fold(f64::INFINITY, f64::min);
        let leftmost = (0..edges.len()).filter(|&at| ranges[at][0] <= least).reduce(|best, at| {
            if self.view.order(edges[at].from, edges[best].from) == Sign::Negative { at } else { best }
        });
        let Some(at) = leftmost else { return Sign::Zero };
        let before = self.directed(edges[(at + edges.len() - 1) % edges.len()]);
        let after = self.directed(edges[at]);
        self.view.turn(before[0], before[1], after[1])
    }

    /// The ends of an edge's support in the edge's direction.
    fn directed(&self, edge: Edge) -> [predicament_predicates::Vertex; 2] {
        let [a, b] = edge.support;
        if self.view.along([a, b]).order(edge.from, edge.to) == Sign::Positive { [b, a] } else { [a, b] }
    }
}

/// Divides a closed walk into simple loops, at nodes that it visits again.
fn simple_loops(subdivision: &Subdivision, walk: &[u32], place: &mut [u32]) -> Vec<Vec<u32>> {
    let mut loops = Vec::new();
    let mut path: Vec<u32> = Vec::with_capacity(walk.len());
    for &half in walk {
        let node = subdivision.origin(half) as usize;
        if place[node] != NONE {
            // The walk since then is a loop.
            let rest = path.split_off(place[node] as usize);
            rest.iter().for_each(|&half| place[subdivision.origin(half) as usize] = NONE);
            loops.push(rest);
        }
        place[node] = super::number(path.len());
        path.push(half);
    }
    path.iter().for_each(|&half| place[subdivision.origin(half) as usize] = NONE);
    loops.push(path);
    loops
}

impl Arrangement {
    /// The run of a half-edge, if it is one.
    fn run(&self, half: u32) -> Option<&Run> {
        self.runs.get((half as usize / 2).checked_sub(self.pieces.len() - self.runs.len())?)
    }

    /// The ends of the segment of a half-edge.
    fn subdivision_segment(&self, half: u32) -> [predicament_predicates::Vertex; 2] {
        self.segments[self.pieces[half as usize / 2].segment as usize]
    }

    /// Prepares the extraction of the regions of results.
    pub(super) fn extraction<'a>(
        &'a self,
        session: &'a dyn Predicates,
        windings: &'a [[i32; 2]],
        rules: [Rule; 2],
        apart: &'a [Region],
    ) -> Extraction<'a> {
        Extraction { view: View::new(session), arrangement: self, windings, rules, apart }
    }
}
