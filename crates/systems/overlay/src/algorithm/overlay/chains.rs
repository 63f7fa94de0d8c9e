//! The vertices on each segment in order, and the pieces between them.

use predicament_predicates::{Axis, Construction, Plane, Predicates, Refused, Scene, Sign, Vertex};

use super::far::Run;
use super::meet::{Meetings, Pair};
use super::supports::{Label, Supports};
use super::view::View;
use super::{Contradiction, NONE, number, partial};
use predicament_grid::sort::sort_by_sign;

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

/// Vertices at one position, by union-find; the root of a class is its lowest slot.
struct Places(Vec<u32>);

impl Places {
    fn root(&mut self, mut slot: u32) -> u32 {
        while self.0[slot as usize] != slot {
            self.0[slot as usize] = self.0[self.0[slot as usize] as usize];
            slot = self.0[slot as usize];
        }
        slot
    }

    fn unite(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b) as usize] = a.min(b);
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
        meetings: Meetings,
        runs: Vec<Run>,
    ) -> Result<Chains, Refused> {
        let on_segments = constructed(session, supports, meetings)?;
        let view = View::new(session);
        let scene = session.scene();
        let slots = Slots { inputs: scene.len() };
        let mut places = Places((0..number(scene.len() + scene.constructions().len())).collect());
        for [a, b] in &on_segments.same {
            places.unite(slots.of(*a), slots.of(*b));
        }
        // A segment without length is a point.
        for [a, b] in supports.ends.iter().filter(|[a, b]| scene.point(*a) == scene.point(*b)) {
            if view.is_same_place(*a, *b) {
                places.unite(slots.of(*a), slots.of(*b));
            }
        }
        let mut chains = Chains::default();
        chains.first.reserve(supports.ends.len() + 1);
        chains.along.reserve(2 * supports.ends.len() + on_segments.vertices.len());
        let mut about = About::new(scene);
        let mut inner: Vec<Vertex> = Vec::new();
        for (segment, &ends) in supports.ends.iter().enumerate() {
            chains.first.push(number(chains.along.len()));
            inner.clear();
            inner.extend_from_slice(on_segments.of(segment));
            if !supports.are_whole {
                inner.extend(supports.spans(segment).iter().flat_map(|span| [span.from, span.to]));
            } else if inner.is_empty() {
                chains.along.extend(ends.map(|v| slots.of(v)));
                continue;
            } else if on_segments.may_be_ends {
                inner.extend(ends);
            }
            let has_ties = sort_along(view, ends, &mut inner, &mut about);
            let is_open = supports.are_whole && !on_segments.may_be_ends;
            if has_ties {
                let along = view.along(ends);
                for pair in inner.windows(2) {
                    if pair[0] != pair[1] && along.order(pair[0], pair[1]) == Sign::Zero {
                        places.unite(slots.of(pair[0]), slots.of(pair[1]));
                    }
                }
            }
            chains.along.extend(is_open.then(|| slots.of(ends[0])));
            chains.along.extend(inner.iter().map(|&v| slots.of(v)));
            chains.along.extend(is_open.then(|| slots.of(ends[1])));
        }
        chains.first.push(number(chains.along.len()));
        let node = chains.number_nodes(scene, slots, &mut places);
        let mut node_of = |v: Vertex| node[places.root(slots.of(v)) as usize];
        chains.cut(supports, &mut node_of, on_segments.has_overlaps);
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

    /// Converts slots to nodes, one for each position on a segment; returns the node of each representative slot.
    fn number_nodes(&mut self, scene: &Scene, slots: Slots, places: &mut Places) -> Vec<u32> {
        let mut node = vec![NONE; places.0.len()];
        for slot in &mut self.along {
            *slot = places.root(*slot);
            node[*slot as usize] = 0;
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
        if !constructed.is_sorted_by_key(|&v| scene.construction(v)) {
            constructed.sort_by_key(|&v| scene.construction(v));
        }
        self.nodes.append(&mut constructed);
        for (at, &v) in self.nodes.iter().enumerate() {
            node[slots.of(v) as usize] = number(at);
        }
        self.along.iter_mut().for_each(|slot| *slot = node[*slot as usize]);
        self.join_repeats();
        node
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

    /// Makes the pieces between the nodes, each once.
    fn cut(&mut self, supports: &Supports, mut node_of: impl FnMut(Vertex) -> u32, has_overlaps: bool) {
        self.piece = vec![NONE; self.along.len()];
        self.pieces.reserve(self.along.len());
        let mut sums: Vec<(Label, i32)> = Vec::new();
        for segment in 0..supports.ends.len() {
            let range = self.of(segment);
            let spans = supports.spans(segment);
            if !supports.are_whole {
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
            }
            for at in range.clone().skip(1) {
                let ends = [self.along[at - 1], self.along[at]];
                let (label, covers) = if supports.are_whole { (spans[0].label, 1) } else { sums[at - 1 - range.start] };
                if ends[0] != ends[1] && covers > 0 {
                    self.piece[at - 1] = number(self.pieces.len());
                    self.pieces.push(Piece { ends, segment: number(segment), label });
                }
            }
        }
        if has_overlaps {
            self.join_pieces();
        }
    }

    /// Merges the pieces between the same two nodes.
    fn join_pieces(&mut self) {
        let key = |piece: &Piece| [piece.ends[0].min(piece.ends[1]), piece.ends[0].max(piece.ends[1])];
        let mut order: Vec<([u32; 2], u32)> = self.pieces.iter().map(key).zip(0..).collect();
        order.sort_unstable();
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

/// The inner vertices of each segment, unsorted.
struct OnSegments {
    first: Vec<u32>,
    vertices: Vec<Vertex>,
    same: Vec<[Vertex; 2]>,
    has_overlaps: bool,
    /// True if some of the vertices can coincide with an end of their segment.
    may_be_ends: bool,
}

impl OnSegments {
    fn of(&self, segment: usize) -> &[Vertex] {
        &self.vertices[self.first[segment] as usize..self.first[segment + 1] as usize]
    }
}

/// Constructs the crossings, in the order of the segments.
fn constructed(session: &mut dyn Predicates, supports: &Supports, meetings: Meetings) -> Result<OnSegments, Refused> {
    let Meetings { crossings, mut touches, same, overlaps, bundles, .. } = meetings;
    // A bundle's point is defined by its first segment and the first that crosses it.
    let mut defined: Vec<(Pair, Option<&[u32]>)> = crossings.iter().map(|&pair| (pair, None)).collect();
    for bundle in &bundles {
        let view = View::new(&*session);
        let [a, b] = supports.ends[bundle[0] as usize];
        let leaves = |&&other: &&u32| supports.ends[other as usize].iter().any(|&v| view.turn(a, b, v) != Sign::Zero);
        if let Some(&other) = bundle[1..].iter().find(leaves) {
            defined.push(([bundle[0], other], Some(bundle)));
        }
    }
    if !bundles.is_empty() {
        defined.sort();
    }
    let definition = |&(pair, _): &(Pair, _)| Construction::Ssi(pair.map(|at| supports.ends[at as usize]));
    // If nothing crosses, a session without constructions suffices.
    let definitions: Vec<Construction> = defined.iter().map(definition).collect();
    let points = if definitions.is_empty() { Vec::new() } else { session.construct(&definitions)? };
    let mut on: Vec<(u32, Vertex)> = Vec::with_capacity(2 * points.len() + touches.len());
    for ((pair, bundle), &point) in defined.iter().zip(&points) {
        match bundle {
            None => on.extend(pair.map(|at| (at, point))),
            Some(bundle) => on.extend(bundle.iter().map(|&at| (at, point))),
        }
    }
    on.append(&mut touches);
    if !supports.are_whole {
        partial::keep_what_edges_reach(&*session, supports, &overlaps, &mut on);
    }
    let mut first = vec![0_u32; supports.ends.len() + 1];
    on.iter().for_each(|(segment, _)| first[*segment as usize] += 1);
    let mut end = 0;
    for start in &mut first {
        end += *start;
        *start = end;
    }
    let mut vertices = vec![Vertex::input(0); on.len()];
    for &(segment, v) in on.iter().rev() {
        let start = &mut first[segment as usize];
        *start -= 1;
        vertices[*start as usize] = v;
    }
    let (has_overlaps, may_be_ends) = (!overlaps.is_empty(), !bundles.is_empty());
    Ok(OnSegments { first, vertices, same, has_overlaps, may_be_ends })
}

/// Sorts vertices along a segment: by rounded coordinates first, then by signs, which change little. False if the sort
/// has shown that all are apart: it compares all neighbours of the result.
fn sort_along(view: View<'_>, ends: [Vertex; 2], inner: &mut [Vertex], about: &mut About<'_>) -> bool {
    if inner.len() < 2 {
        return false;
    }
    let along = view.along(ends);
    let axis = if along.axis == Axis::X { 0 } else { 1 };
    about.sort(inner, axis, along.is_rising());
    let mut has_ties = false;
    sort_by_sign(inner, |a, b| {
        let sign = along.order(a, b);
        has_ties |= sign == Sign::Zero;
        sign
    });
    has_ties
}

/// Approximate positions of vertices: they give the order before signs do.
struct About<'s> {
    scene: &'s Scene,
    keys: Vec<(f64, Vertex)>,
}

impl<'s> About<'s> {
    fn new(scene: &'s Scene) -> About<'s> {
        About { scene, keys: Vec::new() }
    }

    fn sort(&mut self, vertices: &mut [Vertex], axis: usize, is_rising: bool) {
        self.keys.clear();
        let scene = self.scene;
        self.keys.extend(vertices.iter().map(|&v| (about(scene, v)[axis], v)));
        self.keys.sort_unstable_by(|a, b| {
            let order = a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
            if is_rising { order } else { order.reverse() }
        });
        vertices.iter_mut().zip(&self.keys).for_each(|(v, key)| *v = key.1);
    }
}

fn about(scene: &Scene, v: Vertex) -> [f64; 2] {
    let at = |v: Vertex| if v.is_constructed() { [f64::NAN; 2] } else { scene.point2(Plane::Xy, v) };
    match scene.construction(v) {
        None => at(v),
        Some(Construction::Ssi(lines)) => {
            let [[a, b], [c, d]] = lines.map(|line| line.map(at));
            let minus = |p: [f64; 2], q: [f64; 2]| [p[0] - q[0], p[1] - q[1]];
            let [u, v, way] = [minus(b, a), minus(d, c), minus(c, a)];
            let part = (way[0] * v[1] - way[1] * v[0]) / (u[0] * v[1] - u[1] * v[0]);
            [a[0] + part * u[0], a[1] + part * u[1]]
        }
        Some(_) => [f64::NAN; 2],
    }
}
