//! The vertices on each segment in order, and the pieces between them.

use std::ops::Range;

use predicament_grid::parallel;
use predicament_predicates::{Predicates, Refused, Scene, Vertex};

use super::along::{self, OnSegments, Order};
use super::far::Run;
use super::meet::{Crossing, Meetings};
use super::reach::Reach;
use super::supports::{Label, Supports};
use super::view::View;
use super::{Contradiction, NONE, number};

/// A part of a segment between two consecutive vertices.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Piece {
    /// The nodes at its ends, in the order from the segment's lower vertex to the other.
    pub ends: [u32; 2],
    /// Its segment, or the first of several. `u32::MAX` for a run of edges, which [`combine`](super::combine) makes.
    pub segment: u32,
    /// For each operand, the number of times that it passes the piece in this direction, less the times back.
    pub label: [i32; 2],
}

/// The nodes and pieces on each segment.
#[derive(Default)]
pub(super) struct Chains {
    /// The vertex of each node: input vertices by index, then constructed ones by definition.
    pub nodes: Vec<Vertex>,
    /// The number of nodes that are input vertices.
    pub inputs: usize,
    /// The index of each segment's first node in `along`; then the length of `along`.
    pub first: Vec<u32>,
    /// The nodes on each segment in order, segment after segment.
    pub along: Vec<u32>,
    /// For each entry of `along`, the piece to the next node on its segment; `NONE` after the last, and where no edge
    /// passes.
    pub piece: Vec<u32>,
    /// The pieces: parts of segments, then runs.
    pub pieces: Vec<Piece>,
    /// The runs; the last pieces stand for them, in the same order.
    pub runs: Vec<Run>,
    /// The crossing of each constructed node, if each is a crossing of two segments and nothing else.
    pub crossings: Vec<Crossing>,
    /// The first rule that signs break.
    pub broken: Option<Contradiction>,
}

/// A common numbering of vertices: input vertices first, then constructed ones.
#[derive(Clone, Copy)]
struct Slots {
    inputs: usize,
}

impl Slots {
    fn of(self, v: Vertex) -> u32 {
        v.construction().map_or_else(|| number(v.index()), |index| number(self.inputs + index))
    }

    fn vertex(self, slot: u32) -> Vertex {
        let slot = slot as usize;
        if slot < self.inputs { Vertex::input(slot) } else { Vertex::constructed(slot - self.inputs) }
    }
}

/// Vertices at one position, by union-find; the root of a class is its lowest slot. Vertices beyond the list are apart.
struct Places(Vec<u32>);

impl Places {
    fn new(slots: Slots, scene: &Scene, same: &[[Vertex; 2]]) -> Places {
        let count = match same.as_flattened().iter().max() {
            None => 0,
            Some(v) if !v.is_constructed() => slots.inputs,
            Some(_) => slots.inputs + scene.constructions().len(),
        };
        let mut places = Places((0..number(count)).collect());
        same.iter().for_each(|pair| places.unite(pair.map(|v| slots.of(v))));
        places
    }

    fn root(&mut self, mut slot: u32) -> u32 {
        if slot as usize >= self.0.len() {
            return slot;
        }
        while self.0[slot as usize] != slot {
            self.0[slot as usize] = self.0[self.0[slot as usize] as usize];
            slot = self.0[slot as usize];
        }
        slot
    }

    fn unite(&mut self, [a, b]: [u32; 2]) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b) as usize] = a.min(b);
    }
}

/// The nodes of slots.
struct Nodes {
    /// The node of each of the first slots; `NONE` if it has none.
    node: Vec<u32>,
    /// The difference of the others and their nodes.
    less: u32,
}

impl Nodes {
    #[inline]
    fn of(&self, slot: u32) -> u32 {
        self.node.get(slot as usize).copied().unwrap_or_else(|| slot - self.less)
    }
}

impl Chains {
    /// Constructs the crossings and sorts the vertices on each segment.
    ///
    /// # Errors
    /// [`Refused`] if the session does not construct a crossing.
    pub fn new(
        session: &mut dyn Predicates,
        supports: &Supports,
        reach: &Reach,
        meetings: Meetings,
        runs: Vec<Run>,
    ) -> Result<Chains, Refused> {
        let on_segments = OnSegments::new(session, supports, reach, meetings)?;
        let view = View::new(session);
        let scene = session.scene();
        let slots = Slots { inputs: scene.len() };
        let count = supports.ends.len();
        let sort = |range: Range<usize>| Sorted::new(view, supports, &on_segments, range);
        let sorted = parallel::uneven(count, count + on_segments.vertices.len(), &sort).joined(|all, mut sorted| {
            let before = number(all.along.len());
            all.first.extend(sorted.first.iter().map(|first| before + first));
            all.along.append(&mut sorted.along);
            all.same.append(&mut sorted.same);
        });
        let Sorted { first, along, mut same } = sorted;
        same.extend_from_slice(&on_segments.same);
        let mut chains = Chains { first, along, ..Chains::default() };
        chains.first.push(number(chains.along.len()));
        let mut places = Places::new(slots, scene, &same);
        // All constructed vertices are on segments, and at positions of their own.
        let are_new = on_segments.are_ascending && supports.are_whole && places.0.len() <= slots.inputs;
        let numbers = chains.number_nodes(scene, slots, &mut places, on_segments.are_ascending, are_new);
        // Crossings and touches of a segment are different vertices, and not its ends.
        let are_apart = supports.are_whole && same.is_empty() && !on_segments.may_be_ends;
        if !are_apart {
            chains.join_repeats();
        }
        let mut node_of = |v: Vertex| numbers.of(places.root(slots.of(v)));
        chains.cut(supports, &mut node_of);
        if on_segments.has_overlaps {
            chains.join_pieces(are_new);
        }
        if are_new {
            chains.crossings = on_segments.crossings;
        }
        for run in runs {
            let ends = run.ends().map(&mut node_of);
            if ends.contains(&NONE) || ends[0] == ends[1] {
                chains.broken.get_or_insert(Contradiction::Ends);
                continue;
            }
            let mut label = [0; 2];
            label[run.operand] = 1;
            chains.pieces.push(Piece { ends, segment: NONE, label });
            chains.runs.push(run);
        }
        Ok(chains)
    }

    /// The nodes of a segment.
    pub fn of(&self, segment: usize) -> std::ops::Range<usize> {
        self.first[segment] as usize..self.first[segment + 1] as usize
    }

    /// Converts slots to nodes, one for each position on a segment; returns the nodes of representative slots.
    ///
    /// If `are_new`, constructed vertices are numbered in their order.
    fn number_nodes(
        &mut self,
        scene: &Scene,
        slots: Slots,
        places: &mut Places,
        are_ascending: bool,
        are_new: bool,
    ) -> Nodes {
        let all = scene.constructions().len();
        let counted = if are_new { all } else { 0 };
        let mut node = vec![NONE; slots.inputs + all - counted];
        for slot in &mut self.along {
            *slot = places.root(*slot);
            if let Some(node) = node.get_mut(*slot as usize) {
                *node = 0;
            }
        }
        let (inputs, constructed) = node.split_at(slots.inputs);
        let used = |of: &[u32], from: usize| -> Vec<Vertex> {
            let used = of.iter().enumerate().filter(|(_, node)| **node == 0);
            used.map(|(at, _)| slots.vertex(number(from + at))).collect()
        };
        self.nodes = used(inputs, 0);
        self.inputs = self.nodes.len();
        let mut constructed = used(constructed, slots.inputs);
        // Vertices constructed in one call are in this order already.
        if !are_ascending && !constructed.is_sorted_by_key(|&v| scene.construction(v)) {
            constructed.sort_by_key(|&v| scene.construction(v));
        }
        self.nodes.append(&mut constructed);
        for (at, &v) in self.nodes.iter().enumerate() {
            node[slots.of(v) as usize] = number(at);
        }
        self.nodes.extend((0..counted).map(Vertex::constructed));
        let nodes = Nodes { less: number(slots.inputs - self.inputs), node };
        self.along.iter_mut().for_each(|slot| *slot = nodes.of(*slot));
        nodes
    }

    /// Merges consecutive vertices at one position of a segment into one node of its chain.
    fn join_repeats(&mut self) {
        let mut kept = 0;
        for segment in 0..self.first.len() - 1 {
            let range = self.of(segment);
            let start = kept;
            for at in range {
                if kept == start || self.along[at] != self.along[kept - 1] {
                    self.along[kept] = self.along[at];
                    kept += 1;
                }
            }
            // The next segment's range is read after this.
            self.first[segment] = number(start);
        }
        self.along.truncate(kept);
        if let Some(last) = self.first.last_mut() {
            *last = number(kept);
        }
    }

    /// Makes the pieces between the nodes, for each segment its own.
    fn cut(&mut self, supports: &Supports, node_of: impl FnMut(Vertex) -> u32) {
        self.pieces.reserve(self.along.len());
        if supports.are_whole {
            self.piece.reserve(self.along.len());
            for segment in 0..supports.ends.len() {
                let along = &self.along[self.first[segment] as usize..self.first[segment + 1] as usize];
                let label = supports.spans(segment)[0].label;
                let before = number(self.pieces.len());
                let piece = |ends: &[u32]| Piece { ends: [ends[0], ends[1]], segment: number(segment), label };
                self.pieces.extend(along.windows(2).map(piece));
                self.piece.extend(before..number(self.pieces.len()));
                self.piece.extend((!along.is_empty()).then_some(NONE));
            }
        } else {
            self.cut_parts(supports, node_of);
        }
    }

    /// Makes the pieces where edges pass their segments in parts. Consecutive nodes of a chain differ.
    fn cut_parts(&mut self, supports: &Supports, mut node_of: impl FnMut(Vertex) -> u32) {
        self.piece = vec![NONE; self.along.len()];
        let mut sums: Vec<(Label, i32)> = Vec::new();
        for segment in 0..supports.ends.len() {
            let range = self.of(segment);
            let spans = supports.spans(segment);
            sums.clear();
            sums.resize(range.len(), ([0; 2], 0));
            for span in spans {
                let [from, to] = [span.from, span.to].map(&mut node_of);
                let place = |node| self.along[range.clone()].iter().position(|&other| other == node);
                let between = place(from).zip(place(to)).filter(|(from, to)| from <= to);
                let Some((from, to)) = between else {
                    self.broken.get_or_insert(Contradiction::Ends);
                    continue;
                };
                for (sum, covers) in &mut sums[from..to] {
                    *covers += 1;
                    sum.iter_mut().zip(span.label).for_each(|(sum, more)| *sum = sum.saturating_add(more));
                }
            }
            for at in range.clone().skip(1) {
                let ends = [self.along[at - 1], self.along[at]];
                let (label, covers) = sums[at - 1 - range.start];
                if covers > 0 {
                    self.piece[at - 1] = number(self.pieces.len());
                    self.pieces.push(Piece { ends, segment: number(segment), label });
                }
            }
        }
    }

    /// Merges the pieces between the same two nodes.
    ///
    /// If `are_new`, each constructed node is the crossing of two segments and nothing else. These segments have no
    /// second crossing, so one of the two nodes is an input vertex.
    fn join_pieces(&mut self, are_new: bool) {
        let key = |piece: &Piece| [piece.ends[0].min(piece.ends[1]), piece.ends[0].max(piece.ends[1])];
        let is_open = |(ends, _): &([u32; 2], u32)| !are_new || (ends[0] as usize) < self.inputs;
        let mut order: Vec<([u32; 2], u32)> = self.pieces.iter().map(key).zip(0..).filter(is_open).collect();
        order.sort_unstable();
        if order.windows(2).all(|pair| pair[0].0 != pair[1].0) {
            return;
        }
        // The first piece of each group stays.
        let mut kept: Vec<u32> = (0..number(self.pieces.len())).collect();
        for group in order.chunk_by(|a, b| a.0 == b.0) {
            for &(_, at) in &group[1..] {
                let other = self.pieces[at as usize];
                let first = &mut self.pieces[group[0].1 as usize];
                let direction = if first.ends == other.ends { 1 } else { -1 };
                for (sum, more) in first.label.iter_mut().zip(other.label) {
                    *sum = sum.saturating_add(direction * more);
                }
                kept[at as usize] = group[0].1;
            }
        }
        let mut place = vec![NONE; self.pieces.len()];
        let mut count = 0;
        for at in 0..self.pieces.len() {
            if kept[at] as usize == at {
                place[at] = number(count);
                self.pieces[count] = self.pieces[at];
                count += 1;
            }
        }
        self.pieces.truncate(count);
        for piece in self.piece.iter_mut().filter(|piece| **piece != NONE) {
            *piece = place[kept[*piece as usize] as usize];
        }
    }
}

/// The chains of some segments.
#[derive(Default)]
struct Sorted {
    /// The index of each segment's first vertex.
    first: Vec<u32>,
    /// The slots of the vertices on each segment in order, segment after segment.
    along: Vec<u32>,
    /// Pairs of vertices at one position.
    same: Vec<[Vertex; 2]>,
}

impl Sorted {
    /// Sorts the vertices on some segments.
    fn new(view: View<'_>, supports: &Supports, on_segments: &OnSegments, segments: Range<usize>) -> Sorted {
        let scene = view.session.scene();
        let slots = Slots { inputs: scene.len() };
        let mut sorted = Sorted::default();
        sorted.first.reserve(segments.len() + 1);
        let inner = on_segments.first[segments.end] - on_segments.first[segments.start];
        sorted.along.reserve(2 * segments.len() + inner as usize);
        let mut order = Order::new(view, supports);
        let mut inner = Vec::new();
        for segment in segments {
            sorted.first.push(number(sorted.along.len()));
            let ends = supports.ends[segment];
            // A segment without length is a point.
            if scene.point(ends[0]) == scene.point(ends[1]) && view.is_same_place(ends[0], ends[1]) {
                sorted.same.push(ends);
            }
            inner.clear();
            inner.extend_from_slice(on_segments.of(segment));
            if !supports.are_whole {
                let spans = supports.spans(segment).iter();
                inner.extend(spans.flat_map(|span| [span.from, span.to]).map(|v| along::inner(scene, ends, v)));
            } else if inner.is_empty() {
                sorted.along.extend(ends.map(|v| slots.of(v)));
                continue;
            } else if on_segments.may_be_ends {
                inner.extend(ends.map(|v| along::inner(scene, ends, v)));
            }
            order.sort(segment, &mut inner, &mut sorted.same);
            let is_open = supports.are_whole && !on_segments.may_be_ends;
            sorted.along.extend(is_open.then(|| slots.of(ends[0])));
            sorted.along.extend(order.vertices.iter().map(|&v| slots.of(v)));
            sorted.along.extend(is_open.then(|| slots.of(ends[1])));
        }
        sorted
    }
}
