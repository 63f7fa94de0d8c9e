//! Segments that edges pass only in parts: vertices constructed elsewhere on them are dropped.

use predicament_predicates::{Predicates, Sign, Vertex};

use super::meet::Pair;
use super::supports::Supports;
use super::view::View;

/// Keeps the vertices on segments where edges pass, and adds ends of edges that are on another edge of the same line.
///
/// A crossing of two segments counts if edges reach it on both; a segment's end counts if it is the end of an edge.
pub(super) fn keep_what_edges_reach(
    session: &dyn Predicates,
    supports: &Supports,
    overlaps: &[Pair],
    on: &mut Vec<(u32, Vertex)>,
) {
    let view = View::new(session);
    let reaches = |segment: u32, v: Vertex| {
        let along = view.along(supports.ends[segment as usize]);
        let is_in =
            |from: Vertex, to: Vertex| along.order(from, v) != Sign::Positive && along.order(v, to) != Sign::Positive;
        supports.spans(segment as usize).iter().any(|span| is_in(span.from, span.to))
    };
    // Ends of edges on one line are compared with each other: no pair of segments finds a vertex that a third segment
    // constructed.
    for &[i, j] in overlaps {
        for (segment, other) in [(i, j), (j, i)] {
            let along = view.along(supports.ends[segment as usize]);
            let [a, b] = supports.ends[segment as usize];
            for v in supports.spans(other as usize).iter().flat_map(|span| [span.from, span.to]) {
                if along.order(a, v) != Sign::Positive && along.order(v, b) != Sign::Positive {
                    on.push((segment, v));
                }
            }
        }
    }
    let mut is_end = vec![false; session.scene().len()];
    for segment in 0..supports.ends.len() {
        for v in supports.spans(segment).iter().flat_map(|span| [span.from, span.to]) {
            if !v.is_constructed() {
                is_end[v.index()] = true;
            }
        }
        // An edge that ends at its segment's end may name another vertex at that position.
        let along = view.along(supports.ends[segment]);
        for end in supports.ends[segment] {
            let is_there = |v: Vertex| v != end && along.order(v, end) == Sign::Zero;
            if supports.spans(segment).iter().any(|span| is_there(span.from) || is_there(span.to)) {
                is_end[end.index()] = true;
                on.push((super::number(segment), end));
            }
        }
    }
    on.sort_unstable_by_key(|&(segment, v)| (v, segment));
    on.dedup();
    let mut kept = Vec::with_capacity(on.len());
    for group in on.chunk_by(|a, b| a.1 == b.1) {
        let v = group[0].1;
        if v.is_constructed() {
            // Lines may cross where edges do not reach; that is not a crossing.
            let reached = group.iter().copied().filter(|&(segment, v)| reaches(segment, v));
            let before = kept.len();
            kept.extend(reached);
            if kept.len() - before < 2 && !is_end_of_edge(supports, group, v) {
                kept.truncate(before);
            }
        } else if is_end[v.index()] {
            kept.extend(group.iter().copied().filter(|&(segment, v)| reaches(segment, v)));
        }
    }
    *on = kept;
}

/// True if an edge on one of these segments ends at the vertex.
fn is_end_of_edge(supports: &Supports, group: &[(u32, Vertex)], v: Vertex) -> bool {
    group.iter().any(|&(segment, _)| supports.spans(segment as usize).iter().any(|span| span.from == v || span.to == v))
}
