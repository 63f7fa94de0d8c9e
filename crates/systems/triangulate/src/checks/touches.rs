//! Contacts and crossings of loops.

use std::cmp::Ordering;

use predicament_judge::boxes::{Boxes, Extent, extent};
use predicament_predicates::Vertex;

use super::fault::{Fault, FaultKind};
use super::nesting::edges;
use super::plane::Points;

/// The maximum number of pairs of edges with meeting boxes, for each edge; beyond it, loops are not compared.
const MOST_NEAR: usize = 64;

/// Two edges without a common vertex that have a common point.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Touch {
    /// The ends of both edges.
    pub edges: [[Vertex; 2]; 2],
}

/// The places where loops touch and cross.
#[derive(Clone, Debug, Default)]
pub struct Touches {
    /// True if all pairs of edges were compared; otherwise the lists are empty.
    pub is_known: bool,
    /// Edges that touch.
    pub touching: Vec<Touch>,
    /// Two edges that may not be where they are.
    pub(super) fault: Option<Fault>,
    /// Pairs of a vertex and the edge that it is on, as indices.
    pub(super) on_edges: Vec<(usize, [usize; 2])>,
}

impl Touches {
    /// Compares the edges of loops with the inside on their left; `is_hole` has an entry for each loop.
    pub(super) fn new(points: &Points, loops: &[Vec<usize>], is_hole: &[bool]) -> Touches {
        let all: Vec<(usize, [usize; 2])> =
            loops.iter().enumerate().flat_map(|(at, one)| edges(one).map(move |edge| (at, edge))).collect();
        let boxes: Vec<Extent<2>> = all.iter().map(|(_, edge)| extent(edge.map(|place| points.raw(place)))).collect();
        let mut left = MOST_NEAR * all.len();
        let index = Boxes::new(boxes);
        let mut touches = Touches { is_known: true, ..Touches::default() };
        let mut near = Vec::new();
        for (at, &edge) in all.iter().enumerate() {
            index.near(&index.all()[at], 0.0, &mut near);
            let Some(rest) = left.checked_sub(near.len()) else { return Touches::default() };
            left = rest;
            near.iter()
                .map(|&other| other as usize)
                .filter(|&other| other > at)
                .for_each(|other| touches.look(points, is_hole, edge, all[other]));
        }
        touches
    }

    /// Compares two edges; each comes with its loop.
    fn look(
        &mut self,
        points: &Points,
        is_hole: &[bool],
        (one, e): (usize, [usize; 2]),
        (other, f): (usize, [usize; 2]),
    ) {
        let ends = || [e, f].map(|edge| edge.map(|place| points.vertex(place)));
        let mut is_touching = false;
        let mut is_inside = None;
        for ([a, b], edge) in [(e, f), (f, e)] {
            for end in edge.into_iter().filter(|end| *end != a && *end != b) {
                if points.is_on(a, b, end) {
                    is_touching = true;
                    if !points.is_same_place(a, end) && !points.is_same_place(b, end) {
                        is_inside = Some((end, [a, b]));
                    }
                }
            }
        }
        let side = |[a, b]: [usize; 2], end: usize| points.side(a, b, end);
        let sides = |edge: [usize; 2], [c, d]: [usize; 2]| [side(edge, c), side(edge, d)];
        let opposite = |[x, y]: [Ordering; 2]| x.is_ne() && x == y.reverse();
        let has_length = |[a, b]: [usize; 2]| !points.is_same_place(a, b);
        let same = |[i, j]: [usize; 2]| points.is_same_place(e[i], f[0]) && points.is_same_place(e[j], f[1]);
        let in_line = has_length(e) && has_length(f) && sides(e, f).iter().all(|side| side.is_eq());
        let in_turn = one == other && (e[1] == f[0] || f[1] == e[0]);
        let kind = if in_line && (same([0, 1]) || same([1, 0]) || is_inside.is_some()) {
            // Two outer loops may have an edge in common, one on each side of it.
            let is_between = one != other && !is_hole[one] && !is_hole[other] && same([1, 0]);
            match is_inside {
                _ if in_turn => Some(FaultKind::Spike),
                Some(_) => Some(FaultKind::Overlap),
                None => (!is_between).then_some(FaultKind::Doubled),
            }
        } else {
            let is_apart = !e.iter().any(|end| f.contains(end));
            (is_apart && opposite(sides(e, f)) && opposite(sides(f, e))).then_some(FaultKind::Cross)
        };
        if let Some(kind) = kind {
            self.fault.get_or_insert_with(|| Fault { kind, vertices: ends().as_flattened().to_vec() });
        } else if is_touching {
            self.on_edges.extend(is_inside);
            self.touching.push(Touch { edges: ends() });
        }
    }
}
