//! Triangles without area.
//!
//! A part touches itself where one of its edges is on a plane: the cap goes over that edge. A later plane that crosses
//! the edge then makes a loop with a vertex on another edge of the loop. In a triangulation the edge and that vertex
//! are a triangle without area. The triangle on the other side of the edge is divided at the vertex instead.

use std::collections::BTreeMap;

use predicament_predicates::{Axis, Plane, Predicates, Sign, Vertex};

use super::{Part, Source};

/// A triangle without area.
pub(super) struct Flat {
    /// The longest side, in the direction of the triangle.
    side: [Vertex; 2],
    /// The vertex on that side.
    on: Vertex,
    source: Source,
}

impl Flat {
    /// The triangle, if it has no area in a plane and a vertex between the other two.
    pub(super) fn of(session: &dyn Predicates, plane: Plane, triangle: [Vertex; 3], source: Source) -> Option<Flat> {
        let [a, b, c] = triangle;
        if !session.orient2d(plane, a, b, c).is_zero() {
            return None;
        }
        let is_between = |v: Vertex, [from, to]: [Vertex; 2]| {
            [Axis::X, Axis::Y, Axis::Z].into_iter().any(|axis| {
                let [before, after] = [session.compare(axis, from, v), session.compare(axis, v, to)];
                before == after && before != Sign::Zero
            })
        };
        let sides = [([a, b], c), ([b, c], a), ([c, a], b)];
        sides.into_iter().find(|&(side, on)| is_between(on, side)).map(|(side, on)| Flat { side, on, source })
    }
}

/// Divides the triangles beside those without area; one without a triangle beside it is added as it is.
pub(super) fn divide(part: &mut Part, mut flats: Vec<Flat>) {
    let sides = |[a, b, c]: [Vertex; 3]| [[a, b], [b, c], [c, a]];
    let all = part.triangles.iter().enumerate().flat_map(|(at, &triangle)| sides(triangle).map(|side| (side, at)));
    let mut at_side: BTreeMap<[Vertex; 2], usize> = all.collect();
    // The triangle beside one without area may be another one.
    let mut left = usize::MAX;
    while flats.len() < left {
        left = flats.len();
        flats.retain(|&Flat { side: [from, to], on, .. }| {
            let Some(&at) = at_side.get(&[to, from]) else { return true };
            let Some(&apex) = part.triangles[at].iter().find(|v| **v != from && **v != to && **v != on) else {
                return true;
            };
            let halves = [[to, on, apex], [on, from, apex]];
            at_side.remove(&[to, from]);
            for (triangle, at) in halves.into_iter().zip([at, part.triangles.len()]) {
                at_side.extend(sides(triangle).map(|side| (side, at)));
            }
            part.triangles[at] = halves[0];
            part.triangles.push(halves[1]);
            part.sources.push(part.sources[at]);
            false
        });
    }
    for Flat { side: [from, to], on, source } in flats {
        part.triangles.push([from, to, on]);
        part.sources.push(source);
    }
}
