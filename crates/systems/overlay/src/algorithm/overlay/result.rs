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

use std::collections::HashMap;
use std::ops::Range;

use predicament_grid::parallel;
use predicament_mesh::Subdivision;
use predicament_predicates::Scene;

use super::chains::Piece;
use super::far::{Run, Touched};
use super::polygon::{Edge, Region, Rule};
use super::{Arrangement, Contradiction, NONE};
use crate::answer::Operation;

/// The number of passes over all pieces, before faces are visited one by one.
const PASSES: u32 = 8;

/// The winding numbers of both operands in each face, starting at the unbounded face; and true if they agree around
/// every piece. With an even-odd rule they are 0 and 1, because edges that the operand passes an even number of times
/// are absent.
pub(super) fn windings(subdivision: &Subdivision, pieces: &[Piece], rules: [Rule; 2]) -> (Vec<[i32; 2]>, bool) {
    let masks = Masks::new(rules);
    if let Some(windings) = in_order(subdivision, pieces, masks) {
        return (windings, true);
    }
    let (windings, are_known) = one_by_one(subdivision, pieces, masks);
    let agree = |range: Range<usize>| {
        subdivision.sides()[range.clone()].iter().zip(&pieces[range]).all(|(&[left, right], piece)| {
            masks.right(windings[left as usize], piece.label) == windings[right as usize]
        })
    };
    let agree = are_known && parallel::ranges(pieces.len(), &agree).into_iter().all(|agree| agree);
    (windings, agree)
}

/// The winding numbers of a face that is not reached yet.
const UNKNOWN: [i32; 2] = [i32::MIN; 2];

/// Winding numbers by a few passes over the pieces, in the order of memory: most pieces are next to pieces of which one
/// side is known. `None` if that does not reach all faces, or if the numbers do not agree around every piece.
fn in_order(subdivision: &Subdivision, pieces: &[Piece], masks: Masks) -> Option<Vec<[i32; 2]>> {
    let mut windings = vec![UNKNOWN; subdivision.faces()];
    windings[0] = [0; 2];
    let mut agree = true;
    let sides = subdivision.sides();
    // Returns true if one of the sides is known.
    let mut pass = |piece: u32| {
        let label = pieces[piece as usize].label;
        let [left, right] = sides[piece as usize].map(|face| face as usize);
        match [windings[left], windings[right]] {
            [UNKNOWN, UNKNOWN] => return false,
            [UNKNOWN, own] => windings[left] = masks.left(own, label),
            [own, UNKNOWN] => windings[right] = masks.right(own, label),
            [own, other] => agree &= masks.right(own, label) == other,
        }
        true
    };
    let mut open: Vec<u32> = (0..super::number(pieces.len())).filter(|&piece| !pass(piece)).collect();
    for _ in 1..PASSES {
        // Forth and back.
        open.reverse();
        open.retain(|&piece| !pass(piece));
    }
    (agree && open.is_empty()).then_some(windings)
}

/// Winding numbers from face to face; and true if all faces are reached.
fn one_by_one(subdivision: &Subdivision, pieces: &[Piece], masks: Masks) -> (Vec<[i32; 2]>, bool) {
    let mut windings = vec![[0; 2]; subdivision.faces()];
    let mut is_known = vec![false; windings.len()];
    is_known[0] = true;
    let mut inner = subdivision.inner().to_vec();
    inner.sort_by_key(|&[face, _]| face);
    let mut open = vec![0_u32];
    while let Some(face) = open.pop() {
        let own = windings[face as usize];
        let from = inner.partition_point(|&[other, _]| other < face);
        let within = inner[from..].iter().take_while(|&&[other, _]| other == face).map(|&[_, cycle]| cycle);
        for cycle in subdivision.outer(face).into_iter().chain(within) {
            for half in subdivision.walk_from(subdivision.cycles()[cycle as usize]) {
                let other = subdivision.face(half ^ 1) as usize;
                if !is_known[other] {
                    is_known[other] = true;
                    let label = pieces[half as usize / 2].label;
                    let is_forth = half.is_multiple_of(2);
                    windings[other] = if is_forth { masks.right(own, label) } else { masks.left(own, label) };
                    open.push(super::number(other));
                }
            }
        }
    }
    let are_known = is_known.iter().all(|is| *is);
    (windings, are_known)
}

/// The bits of each operand's winding numbers: all of them, or the last one with an even-odd rule.
#[derive(Clone, Copy)]
struct Masks([i32; 2]);

impl Masks {
    fn new(rules: [Rule; 2]) -> Masks {
        Masks(rules.map(|rule| if rule == Rule::EvenOdd { 1 } else { -1 }))
    }

    /// The winding numbers on the right of a piece, from those on its left.
    #[inline]
    fn right(self, left: [i32; 2], label: [i32; 2]) -> [i32; 2] {
        [0, 1].map(|operand: usize| left[operand].wrapping_sub(label[operand]) & self.0[operand])
    }

    /// The winding numbers on the left of a piece, from those on its right.
    #[inline]
    fn left(self, right: [i32; 2], label: [i32; 2]) -> [i32; 2] {
        [0, 1].map(|operand: usize| right[operand].wrapping_add(label[operand]) & self.0[operand])
    }
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

/// The place of a half-edge between inside and outside.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Mark {
    /// Both its sides are inside, or its left side is outside.
    Inner,
    /// The inside is on its left, and the outside on its right.
    Bound,
    /// As [`Mark::Bound`], and a walk has passed it.
    Walked,
}

/// Closed walks along the half-edges between the inside and the outside.
#[derive(Default)]
struct Walks {
    /// The half-edges of all walks, in order.
    halves: Vec<u32>,
    /// The index of each walk's first half-edge, then the number of half-edges.
    starts: Vec<u32>,
    /// The number of bounds from each node, up to 255. Where several loops meet, each has a vertex.
    at: Vec<u8>,
}

impl Extraction<'_> {
    pub fn regions(&self, operation: Operation) -> Regions {
        let subdivision = &self.arrangement.subdivision;
        let holds = |winding: &[i32; 2]| operation.holds([0, 1].map(|at| self.rules[at].is_inside(winding[at])));
        let is_inside: Vec<bool> = self.windings.iter().map(holds).collect();
        let count = subdivision.edges().len();
        let marks = |edges: Range<usize>| {
            let mark = |is_bound: bool| if is_bound { Mark::Bound } else { Mark::Inner };
            let both = |faces: &[u32; 2]| {
                let [left, right] = faces.map(|face| is_inside[face as usize]);
                [mark(left & !right), mark(!left & right)]
            };
            subdivision.sides()[edges].iter().map(both).collect::<Vec<_>>().into_flattened()
        };
        let marks = parallel::joined(parallel::ranges(count, &marks));
        let (walks, component) = parallel::two(count, || self.walks(marks), || self.components(&is_inside));
        // The loops of some walks, with the components on their sides.
        let loops = |range: Range<usize>| {
            let (mut loops, mut sides) = (Vec::new(), Sides::default());
            for ends in walks.starts[range.start..=range.end].windows(2) {
                let walk = &walks.halves[ends[0] as usize..ends[1] as usize];
                let left = component[subdivision.face(walk[0]) as usize];
                self.simple_loops(walk, &walks.at, &mut |simple| {
                    loops.push(self.bound(simple, left, &walks.at));
                    sides.push(left, simple.iter().map(|half| component[subdivision.face(half ^ 1) as usize]));
                });
            }
            (loops, sides)
        };
        let all = parallel::uneven(walks.starts.len() - 1, walks.halves.len(), &loops);
        let (mut bounds, sides) = all.joined(|(bounds, sides), (mut loops, own)| {
            bounds.append(&mut loops);
            sides.append(&own);
        });
        drop(walks);
        sides.reach(component[0], component.len(), |at, from| bounds[at].is_hole = bounds[at].region == from);
        regions_of(bounds)
    }

    /// The lowest face of each face's component, of the inside or of the outside.
    fn components(&self, is_inside: &[bool]) -> Vec<u32> {
        let subdivision = &self.arrangement.subdivision;
        let mut component: Vec<u32> = (0..super::number(is_inside.len())).collect();
        for faces in subdivision.sides() {
            let faces = faces.map(|face| face as usize);
            if is_inside[faces[0]] == is_inside[faces[1]] {
                unite(&mut component, faces);
            }
        }
        // Lower faces first, so their components are known.
        for face in 0..component.len() {
            component[face] = component[component[face] as usize];
        }
        component
    }

    /// Finds the closed walks along the bounds, each with one part of the inside on its left.
    fn walks(&self, mut marks: Vec<Mark>) -> Walks {
        let subdivision = &self.arrangement.subdivision;
        let mut walks = Walks { halves: Vec::new(), starts: vec![0], at: vec![0; subdivision.nodes()] };
        for start in 0..marks.len() {
            if marks[start] != Mark::Bound {
                continue;
            }
            let mut at = super::number(start);
            while std::mem::replace(&mut marks[at as usize], Mark::Walked) == Mark::Bound {
                walks.halves.push(at);
                let bounds = &mut walks.at[self.arrangement.origin(at) as usize];
                *bounds = bounds.saturating_add(1);
                // Clockwise through the inside, to the next bound. This ends at the latest at the incoming half-edge:
                // its other side is outside, so the half-edge before is a bound.
                at = subdivision.next(at);
                while marks[at as usize] == Mark::Inner {
                    at = subdivision.next(at ^ 1);
                }
            }
            walks.starts.push(super::number(walks.halves.len()));
        }
        if let Some((scene, apart)) = self.apart.filter(|(_, apart)| !apart.is_empty()) {
            let apart = Touched::new(scene, apart);
            for (at, v) in walks.at.iter_mut().zip(&self.arrangement.vertices) {
                *at = at.saturating_add(apart.times(*v));
            }
        }
        walks
    }

    /// Divides a closed walk into simple loops, at nodes that it visits again.
    fn simple_loops(&self, walk: &[u32], bounds_at: &[u8], found: &mut dyn FnMut(&[u32])) {
        let node = |half: &u32| self.arrangement.origin(*half);
        // A node of one bound is visited once.
        let is_shared = |half: &u32| bounds_at[node(half) as usize] > 1;
        if !walk.iter().any(is_shared) {
            return found(walk);
        }
        // The place of each shared node on the path.
        let mut place: HashMap<u32, usize> = HashMap::new();
        let mut path: Vec<u32> = Vec::with_capacity(walk.len());
        for half in walk {
            if is_shared(half)
                && let Some(from) = place.insert(node(half), path.len())
            {
                // The walk since then is a loop.
                found(&path[from..]);
                path[from + 1..].iter().filter(|half| is_shared(half)).for_each(|half| {
                    place.remove(&node(half));
                });
                path.truncate(from);
                place.insert(node(half), from);
            }
            path.push(*half);
        }
        found(&path);
    }

    /// A simple loop in its final form.
    fn bound(&self, halves: &[u32], region: u32, bounds_at: &[u8]) -> Bound {
        let arrangement = self.arrangement;
        let mut edges: Vec<Edge> = Vec::with_capacity(halves.len());
        // The line and the direction of the half-edge before; `None` for a run, whose edges stay apart.
        let mut last = None;
        for &half in halves {
            let piece = &arrangement.pieces[half as usize / 2];
            let at = half as usize % 2;
            if let Some(run) = (piece.segment == NONE).then(|| arrangement.run(half)).flatten() {
                if at == 0 {
                    edges.extend(&run.edges);
                } else {
                    edges.extend(run.edges.iter().rev().map(|edge| edge.reversed()));
                }
                last = None;
            } else {
                let [from, to] = [piece.ends[at], piece.ends[1 - at]];
                let vertex = |node: u32| arrangement.vertices[node as usize];
                let line = Some((piece.segment, at));
                match edges.last_mut() {
                    Some(before) if last == line && bounds_at[from as usize] <= 1 => before.to = vertex(to),
                    _ => {
                        let support = arrangement.segments[piece.segment as usize];
                        edges.push(Edge { from: vertex(from), to: vertex(to), support });
                    }
                }
                last = line;
            }
        }
        // The first half-edge may be in the middle of an edge.
        let piece = &arrangement.pieces[halves[0] as usize / 2];
        let goes_on = last == Some((piece.segment, halves[0] as usize % 2));
        if edges.len() > 1 && goes_on && bounds_at[arrangement.origin(halves[0]) as usize] <= 1 {
            edges[0].from = edges[edges.len() - 1].from;
            edges.pop();
        }
        let first = (0..edges.len()).min_by_key(|&at| edges[at].from).unwrap_or(0);
        edges.rotate_left(first);
        Bound { region, is_hole: false, edges }
    }
}

/// The regions that loops bound.
fn regions_of(mut bounds: Vec<Bound>) -> Regions {
    let mut result = Regions::default();
    // A region's outer loop comes before its holes. A loop begins at its first vertex. Faces have fewer than 31 bits.
    let place = |bound: &Bound| u64::from(bound.region) << 1 | u64::from(bound.is_hole);
    let first = |bound: &Bound| bound.edges.first().map_or(0, |edge| super::number(edge.from.index()));
    let key = |bound: &Bound| place(bound) << 32 | u64::from(first(bound));
    let mut order: Vec<(u64, u32)> = bounds.iter().map(key).zip(0..).collect();
    order.sort_unstable_by(|a, b| {
        let edges = |at: u32| &bounds[at as usize].edges;
        a.0.cmp(&b.0).then_with(|| edges(a.1).cmp(edges(b.1)))
    });
    for group in order.chunk_by(|a, b| a.0 >> 33 == b.0 >> 33) {
        let mut loops = group.iter().map(|(_, at)| std::mem::take(&mut bounds[*at as usize].edges));
        if group.iter().filter(|(key, _)| key >> 32 & 1 == 0).count() == 1 {
            let outer = loops.next().unwrap_or_default();
            result.regions.push(Region { outer, holes: loops.collect() });
        } else {
            result.broken.get_or_insert(Contradiction::Outer);
        }
    }
    // By first edges, unless these are equal, which needs wrong signs.
    result.regions.sort_by_cached_key(|region| region.outer.first().copied());
    if !result.regions.is_sorted() {
        result.regions.sort_unstable();
    }
    result
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

    /// Adds the loops of another list.
    fn append(&mut self, other: &Sides) {
        let before = super::number(self.components.len());
        self.first.extend(other.first.iter().map(|first| before + first));
        self.components.extend_from_slice(&other.components);
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
#[inline]
fn root(component: &mut [u32], mut face: usize) -> usize {
    while component[face] as usize != face {
        component[face] = component[component[face] as usize];
        face = component[face] as usize;
    }
    face
}

/// Joins the components of two faces.
#[inline]
fn unite(component: &mut [u32], [a, b]: [usize; 2]) {
    let (a, b) = (root(component, a), root(component, b));
    component[a.max(b)] = super::number(a.min(b));
}

impl Arrangement {
    /// The run of a half-edge, if it is one.
    fn run(&self, half: u32) -> Option<&Run> {
        self.runs.get((half as usize / 2).checked_sub(self.pieces.len() - self.runs.len())?)
    }

    /// The node where a half-edge begins.
    fn origin(&self, half: u32) -> u32 {
        self.pieces[half as usize / 2].ends[half as usize % 2]
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
