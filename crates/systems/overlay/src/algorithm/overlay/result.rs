//! Winding numbers of faces, and the regions of a result.
//!
//! # Outer loops and holes
//! No predicate says which loops are holes: the faces do. Inside faces that have a common edge are in one component,
//! and outside faces likewise. Each loop has a component inside, on its left, and one or more outside, on its right.
//! The unbounded face is outside. From its component on, each component is reached through loops: a loop that is first
//! reached from its right is an outer one, and a loop that is first reached from its left is a hole.
//!
//! Proof: a loop is simple, so it separates the plane. A component has no edge of a loop in it, so it is on one side of
//! each loop. Two loops have no edge in common and do not cross, so all components at another loop are on one side of
//! this one. So the components on the side away from the unbounded face are only reached through the loop itself.

use predicament_mesh::Subdivision;
use predicament_predicates::Scene;

use super::chains::Piece;
use super::far::{Run, Touched};
use super::polygon::{Edge, Region, Rule};
use super::{Arrangement, Contradiction, NONE};
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
    pub arrangement: &'a Arrangement,
    pub windings: &'a [[i32; 2]],
    pub rules: [Rule; 2],
    /// Other regions of the result in the scene, which touch the extracted ones in vertices at most.
    pub apart: Option<(&'a Scene, &'a [Region])>,
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
        let mut is_bound = vec![false; halves];
        // Where several loops meet, each has a vertex.
        let mut bounds_at = vec![0_u32; subdivision.nodes()];
        // For each face, a face of its component; the lowest is the representative.
        let mut region: Vec<u32> = (0..super::number(is_inside.len())).collect();
        for (half, ends) in (0..).step_by(2).zip(subdivision.edges()) {
            let faces = [half, half + 1].map(|half| subdivision.face(half));
            match faces.map(|face| is_inside[face as usize]) {
                [left, right] if left == right => unite(&mut region, faces),
                [left, _] => {
                    let at = usize::from(!left);
                    is_bound[half as usize + at] = true;
                    bounds_at[ends[at] as usize] += 1;
                }
            }
        }
        if let Some((scene, apart)) = self.apart.filter(|(_, apart)| !apart.is_empty()) {
            let apart = Touched::new(scene, apart);
            for (bounds, v) in bounds_at.iter_mut().zip(&self.arrangement.vertices) {
                *bounds += u32::from(apart.times(*v));
            }
        }
        let mut result = Regions::default();
        let mut bounds: Vec<Bound> = Vec::new();
        let mut sides = Sides::default();
        let mut is_done = vec![false; halves];
        let mut place = vec![NONE; subdivision.nodes()];
        let mut walk = Vec::new();
        for start in (0..halves).filter(|&half| is_bound[half]) {
            if is_done[start] {
                continue;
            }
            self.walk(start, &is_bound, &mut is_done, &mut walk);
            let left = root(&mut region, subdivision.face(super::number(start)));
            let mut push = |simple: &[u32]| {
                bounds.push(self.bound(simple, left, &bounds_at));
                sides.push(left, simple.iter().map(|half| root(&mut region, subdivision.face(half ^ 1))));
            };
            if is_simple(subdivision, &walk, &mut place) {
                push(&walk);
            } else {
                simple_loops(subdivision, &walk, &mut place).iter().for_each(|simple| push(simple));
            }
        }
        let outside = root(&mut region, 0);
        sides.reach(outside, region.len(), |at, from| bounds[at].is_hole = bounds[at].region == from);
        // A region's outer loop comes before its holes. A loop begins at its first vertex.
        let key = |bound: &Bound| (bound.region, bound.is_hole, bound.edges.first().map(|edge| edge.from));
        bounds.sort_unstable_by(|a, b| key(a).cmp(&key(b)).then_with(|| a.edges.cmp(&b.edges)));
        let mut bounds = bounds.into_iter().peekable();
        while let Some(first) = bounds.next() {
            let (mut outer, mut holes) = (usize::from(!first.is_hole), Vec::new());
            while let Some(bound) = bounds.next_if(|bound| bound.region == first.region) {
                outer += usize::from(!bound.is_hole);
                holes.push(bound.edges);
            }
            if outer == 1 {
                result.regions.push(Region { outer: first.edges, holes });
            } else {
                result.broken.get_or_insert(Contradiction::Outer);
            }
        }
        result.regions.sort_unstable();
        result
    }

    /// Finds the half-edges of a bound in order, with the same part of the inside on their left.
    fn walk(&self, start: usize, is_bound: &[bool], is_done: &mut [bool], walk: &mut Vec<u32>) {
        let subdivision = &self.arrangement.subdivision;
        walk.clear();
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
        Bound { region, is_hole: false, edges }
    }
}

/// The components on both sides of each loop.
#[derive(Default)]
struct Sides {
    /// For each loop, the component on its left, then those on its right.
    components: Vec<u32>,
    /// The index of each loop's first component.
    first: Vec<u32>,
}

impl Sides {
    /// Adds a loop by the components on its left and on the right of its edges.
    fn push(&mut self, left: u32, right: impl Iterator<Item = u32>) {
        self.first.push(super::number(self.components.len()));
        self.components.push(left);
        for component in right {
            if self.components.last() != Some(&component) {
                self.components.push(component);
            }
        }
    }

    fn of(&self, at: usize) -> &[u32] {
        let end = self.first.get(at + 1).map_or(self.components.len(), |end| *end as usize);
        &self.components[self.first[at] as usize..end]
    }

    /// Reaches all components from one of them, through loops; `visit` gets each loop with the component from which it
    /// is first reached.
    fn reach(&self, from: u32, components: usize, mut visit: impl FnMut(usize, u32)) {
        // The loops of each component.
        let mut starts = vec![0_u32; components + 1];
        self.components.iter().for_each(|&component| starts[component as usize] += 1);
        let mut end = 0;
        for start in &mut starts {
            end += *start;
            *start = end;
        }
        let mut loops = vec![0_u32; self.components.len()];
        for at in (0..self.first.len()).rev() {
            for &component in self.of(at) {
                let start = &mut starts[component as usize];
                *start -= 1;
                loops[*start as usize] = super::number(at);
            }
        }
        let (mut is_reached, mut is_visited) = (vec![false; components], vec![false; self.first.len()]);
        let mut open = vec![from];
        is_reached[from as usize] = true;
        while let Some(component) = open.pop() {
            let range = starts[component as usize] as usize..starts[component as usize + 1] as usize;
            for &at in &loops[range] {
                let at = at as usize;
                if std::mem::replace(&mut is_visited[at], true) {
                    continue;
                }
                visit(at, component);
                for &other in self.of(at) {
                    if !std::mem::replace(&mut is_reached[other as usize], true) {
                        open.push(other);
                    }
                }
            }
        }
    }
}

/// The representative of a face's component.
fn root(region: &mut [u32], mut face: u32) -> u32 {
    while region[face as usize] != face {
        region[face as usize] = region[region[face as usize] as usize];
        face = region[face as usize];
    }
    face
}

/// Joins the components of two faces.
fn unite(region: &mut [u32], faces: [u32; 2]) {
    let [a, b] = faces.map(|face| root(region, face));
    region[a.max(b) as usize] = a.min(b);
}

/// True if a closed walk visits each node once.
fn is_simple(subdivision: &Subdivision, walk: &[u32], place: &mut [u32]) -> bool {
    let node = |half: &u32| subdivision.origin(*half) as usize;
    let seen = walk.iter().position(|half| std::mem::replace(&mut place[node(half)], 0) != NONE);
    walk[..seen.unwrap_or(walk.len())].iter().for_each(|half| place[node(half)] = NONE);
    seen.is_none()
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
        windings: &'a [[i32; 2]],
        rules: [Rule; 2],
        apart: Option<(&'a Scene, &'a [Region])>,
    ) -> Extraction<'a> {
        Extraction { arrangement: self, windings, rules, apart }
    }
}
