//! The nearer of two triangles over a point.
//!
//! The triangles do not cross, so the answer is the same over the whole common part of their projections. That part is
//! a convex polygon. Its corners are corners of one triangle that the other covers, and crossings of edges. The height
//! of one triangle over the other is linear there, so it is not zero at some corner, unless both are in one plane.
//! `orient3d` gives its sign at a corner: of a triangle and a vertex, or of the four ends of two edges.

use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use super::stab::Direction;

/// True if the triangle `s` is nearer than `t` to the start of the ray; `None` if neither is nearer.
///
/// One ray meets both. `direction` says if the ray goes to larger coordinates.
pub(super) fn is_nearer<P: Predicates + ?Sized>(
    session: &P,
    direction: Direction,
    s: [Vertex; 3],
    t: [Vertex; 3],
) -> Option<bool> {
    let plane = direction.plane;
    let turn = |[a, b, c]: [Vertex; 3]| session.orient2d(plane, a, b, c);
    // True if v, a vertex of the other triangle, is on the lower side of a triangle; `None` if it is on the triangle's
    // plane.
    let is_below = |[a, b, c]: [Vertex; 3], v: Vertex| match session.orient3d(a, b, c, v) * turn([a, b, c]) {
        Sign::Zero => None,
        side => Some(side == Sign::Positive),
    };
    let all_below = |triangle: [Vertex; 3], other: [Vertex; 3]| {
        let sides = other.map(|v| if triangle.contains(&v) { None } else { is_below(triangle, v) });
        let known: Vec<bool> = sides.into_iter().flatten().collect();
        known.first().copied().filter(|first| known.iter().all(|side| side == first))
    };
    let is_up = direction.is_up();
    // The common case: all corners of one are on one side of the other.
    if let Some(s_below) = all_below(t, s) {
        return Some(s_below == is_up);
    }
    if let Some(t_below) = all_below(s, t) {
        return Some(t_below != is_up);
    }
    let covers = |[a, b, c]: [Vertex; 3], v: Vertex| {
        let signs = [[a, b], [b, c], [c, a]].map(|[u, w]| session.orient2d(plane, u, w, v));
        !(signs.contains(&Sign::Positive) && signs.contains(&Sign::Negative))
    };
    for v in s.into_iter().filter(|v| !t.contains(v)) {
        if covers(t, v)
            && let Some(s_below) = is_below(t, v)
        {
            return Some(s_below == is_up);
        }
    }
    for v in t.into_iter().filter(|v| !s.contains(v)) {
        if covers(s, v)
            && let Some(t_below) = is_below(s, v)
        {
            return Some(t_below != is_up);
        }
    }
    let edges = |[a, b, c]: [Vertex; 3]| [[a, b], [b, c], [c, a]];
    for e in edges(s) {
        for f in edges(t) {
            if let Some(s_below) = is_under(session, plane, e, f) {
                return Some(s_below == is_up);
            }
        }
    }
    None
}

/// True if the edge a, b passes under the edge c, d where their projections cross; `None` if the projections do not
/// cross, or the edges meet.
fn is_under<P: Predicates + ?Sized>(
    session: &P,
    plane: Plane,
    [a, b]: [Vertex; 2],
    [c, d]: [Vertex; 2],
) -> Option<bool> {
    if [a, b].contains(&c) || [a, b].contains(&d) {
        return None;
    }
    let turn = session.orient2d(plane, a, b, c);
    let crosses = turn * session.orient2d(plane, a, b, d) == Sign::Negative
        && session.orient2d(plane, c, d, a) * session.orient2d(plane, c, d, b) == Sign::Negative;
    if !crosses {
        return None;
    }
    // If d is below the plane of a, b, c, which turn left, then c, d is below a, b at the crossing.
    match session.orient3d(a, b, c, d) * turn {
        Sign::Zero => None,
        side => Some(side == Sign::Negative),
    }
}
