//! Where loops touch, and whether they cross.

use predicament_grid::{Bounds, BoxIndex};
use predicament_predicates::Vertex;

use super::nesting::edges;
use super::plane::Points;

/// Pairs of edges whose boxes meet: where there are more for each edge, loops are not compared.
const MOST_NEAR: usize = 64;

/// Two edges without a common vertex that have a common point.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Touch {
    /// The ends of both.
    pub edges: [[Vertex; 2]; 2],
}

/// Where loops touch and cross.
#[derive(Clone, Debug, Default)]
pub struct Touches {
    /// Whether all pairs of edges were looked at: if not, the lists are empty.
    pub is_known: bool,
    /// Edges that touch.
    pub touching: Vec<Touch>,
    /// Two edges that cross.
    pub crossing: Option<[[Vertex; 2]; 2]>,
    /// A vertex and the edge that it is on, by places.
    pub(super) on_edges: Vec<(usize, [usize; 2])>,
}

impl Touches {
    pub(super) fn new(points: &Points, loops: &[Vec<usize>]) -> Touches {
        let all: Vec<[usize; 2]> = loops.iter().flat_map(|one| edges(one)).collect();
        let boxes: Vec<Bounds<2>> = all.iter().map(|edge| Bounds::of(edge.map(|place| points.raw(place)))).collect();
        let mut left = MOST_NEAR * all.len();
        let index = BoxIndex::new(boxes);
        let mut touches = Touches { is_known: true, ..Touches::default() };
        let mut near = Vec::new();
        for (at, &edge) in all.iter().enumerate() {
            index.near(&index.boxes()[at], 0.0, &mut near);
            let Some(rest) = left.checked_sub(near.len()) else { return Touches::default() };
            left = rest;
            near.iter()
                .map(|&other| other as usize)
                .filter(|&other| other > at)
                .for_each(|other| touches.look(points, edge, all[other]));
        }
        touches
    }

    fn look(&mut self, points: &Points, e: [usize; 2], f: [usize; 2]) {
        let mut is_touching = false;
        for ([a, b], other) in [(e, f), (f, e)] {
            for end in other.into_iter().filter(|end| *end != a && *end != b) {
                if points.is_on(a, b, end) {
                    is_touching = true;
                    if !points.is_same_place(a, end) && !points.is_same_place(b, end) {
                        self.on_edges.push((end, [a, b]));
                    }
                }
            }
        }
        let ends = || [e, f].map(|edge| edge.map(|place| points.vertex(place)));
        let shared = e.iter().filter(|end| f.contains(end)).count();
        let sides = |[a, b]: [usize; 2], [c, d]: [usize; 2]| [c, d].map(|end| points.side(a, b, end));
        let opposite = |[x, y]: [std::cmp::Ordering; 2]| x.is_ne() && x == y.reverse();
        if shared == 0 && is_touching {
            self.touching.push(Touch { edges: ends() });
        } else if shared == 0 && opposite(sides(e, f)) && opposite(sides(f, e)) || e == f {
            self.crossing.get_or_insert(ends());
        }
    }
}
