//! Edges grouped by the input segments that they are on.
//!
//! Predicates are evaluated for input segments, each once, however many edges are parts of it: repetitions are counted,
//! not compared. So repeated edges need no special treatment, and a broken tie cannot separate them.

use predicament_predicates::{Predicates, Sign, Vertex};

use super::number;
use super::polygon::Edge;
use super::view::View;

/// For each of two operands, the number of times that it passes a piece of a segment from its first end to its second,
/// less the times back.
pub(super) type Label = [i32; 2];

/// A part of a segment that edges pass.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Span {
    /// The end that is nearer to the segment's first end.
    pub from: Vertex,
    pub to: Vertex,
    pub label: Label,
}

/// Input segments with the edges on them.
#[derive(Default)]
pub(super) struct Supports {
    /// The ends of each segment, the lower id first; ascending.
    pub ends: Vec<[Vertex; 2]>,
    /// The index of each segment's first span; then the number of spans.
    first: Vec<u32>,
    spans: Vec<Span>,
    /// True if every segment has one span, which is the whole segment.
    pub are_whole: bool,
    /// True if no segment is left out.
    pub are_all: bool,
}

impl Supports {
    /// Groups edges, each with its operand, by segment. Segments are left out if `is_idle` is true for all their spans:
    /// passing such spans changes nothing.
    pub fn new(session: &dyn Predicates, edges: &[(Edge, usize)], is_idle: impl Fn(Label) -> bool) -> Supports {
        let ends = |edge: &Edge| {
            let [a, b] = edge.support;
            if a < b { [a, b] } else { [b, a] }
        };
        let order = sorted(session.scene().len(), edges.len(), |at| ends(&edges[at].0));
        let mut supports = Supports { are_whole: true, are_all: true, ..Supports::default() };
        supports.ends.reserve(edges.len());
        supports.spans.reserve(edges.len());
        supports.first.reserve(edges.len() + 1);
        for group in order.chunk_by(|&a, &b| ends(&edges[a as usize].0) == ends(&edges[b as usize].0)) {
            let support = ends(&edges[group[0] as usize].0);
            let first = supports.spans.len();
            for &at in group {
                let (edge, operand) = edges[at as usize];
                supports.spans.extend(span(session, support, edge, operand));
            }
            supports.join(first);
            let spans = &supports.spans[first..];
            if spans.iter().all(|span| is_idle(span.label)) {
                supports.spans.truncate(first);
                supports.are_all = false;
                continue;
            }
            supports.are_whole &= spans.len() == 1 && [spans[0].from, spans[0].to] == support;
            supports.ends.push(support);
            supports.first.push(number(first));
        }
        supports.first.push(number(supports.spans.len()));
        supports
    }

    /// The spans of a segment.
    pub fn spans(&self, segment: usize) -> &[Span] {
        &self.spans[self.first[segment] as usize..self.first[segment + 1] as usize]
    }

    /// Merges equal spans.
    fn join(&mut self, first: usize) {
        if self.spans.len() - first < 2 {
            return;
        }
        self.spans[first..].sort_unstable();
        let mut kept = first;
        for at in first + 1..self.spans.len() {
            let span = self.spans[at];
            let last = &mut self.spans[kept];
            if (last.from, last.to) == (span.from, span.to) {
                for (sum, more) in last.label.iter_mut().zip(span.label) {
                    *sum = sum.saturating_add(more);
                }
            } else {
                kept += 1;
                self.spans[kept] = span;
            }
        }
        self.spans.truncate(kept + 1);
    }
}

/// The indices of edges in the order of their segments' ends, and for one segment in their own order.
fn sorted(vertices: usize, count: usize, ends: impl Fn(usize) -> [Vertex; 2]) -> Vec<u32> {
    // A few edges in a large scene, as in a step of a cascade.
    if count < vertices / 16 {
        let mut order: Vec<u32> = (0..number(count)).collect();
        order.sort_by_key(|&at| ends(at as usize));
        return order;
    }
    // Counting sort by their first ends, which are input vertices; then sorted by their second ends, among few.
    let mut starts = vec![0_u32; vertices + 1];
    for at in 0..count {
        starts[ends(at)[0].index()] += 1;
    }
    let mut end = 0;
    for start in &mut starts {
        end += *start;
        *start = end;
    }
    let mut order = vec![0_u32; count];
    for at in (0..count).rev() {
        let start = &mut starts[ends(at)[0].index()];
        *start -= 1;
        order[*start as usize] = number(at);
    }
    for pair in starts.windows(2).filter(|pair| pair[1] - pair[0] > 1) {
        order[pair[0] as usize..pair[1] as usize].sort_by_key(|&at| ends(at as usize)[1]);
    }
    order
}

/// The span of an edge; `None` for an edge without length.
fn span(session: &dyn Predicates, support: [Vertex; 2], edge: Edge, operand: usize) -> Option<Span> {
    let Edge { from, to, .. } = edge;
    let is_ahead = if [from, to] == support {
        true
    } else if [to, from] == support {
        false
    } else {
        match View::new(session).along(support).order(from, to) {
            Sign::Zero => return None,
            sign => sign == Sign::Negative,
        }
    };
    let mut label = [0; 2];
    label[operand] = if is_ahead { 1 } else { -1 };
    let [from, to] = if is_ahead { [from, to] } else { [to, from] };
    Some(Span { from, to, label })
}
