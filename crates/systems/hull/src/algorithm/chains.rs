//! Lower and upper hulls of vertices in lexicographic order.

use predicament_predicates::{Plane, Predicates, Sign, Vertex};

/// A chain between the first and the last vertex.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Side {
    /// The chain below: it turns to the left.
    Lower,
    /// The chain above: it turns to the right.
    Upper,
}

/// True if the chain keeps b between a and c.
fn keeps(session: &dyn Predicates, plane: Plane, side: Side, [a, b, c]: [Vertex; 3]) -> bool {
    let turn = session.orient2d(plane, a, b, c);
    let turn = if side == Side::Lower { turn } else { -turn };
    turn == Sign::Positive
}

/// The chain of sorted vertices, left to right: each new vertex removes the previous vertices that it makes
/// superfluous.
pub(super) fn monotone(session: &dyn Predicates, plane: Plane, side: Side, sorted: &[Vertex]) -> Vec<Vertex> {
    let mut chain: Vec<Vertex> = Vec::new();
    for &v in sorted {
        while let [.., a, b] = chain[..] {
            if keeps(session, plane, side, [a, b, v]) {
                break;
            }
            chain.pop();
        }
        chain.push(v);
    }
    chain
}

/// The chain by divide and conquer. It is written to the front of `out`, which is as long as `sorted`; the result is
/// its length.
pub(super) fn divided(
    session: &dyn Predicates,
    plane: Plane,
    side: Side,
    sorted: &[Vertex],
    out: &mut [Vertex],
) -> usize {
    if sorted.len() < 2 {
        out.copy_from_slice(sorted);
        return sorted.len();
    }
    let middle = sorted.len() / 2;
    let left = divided(session, plane, side, &sorted[..middle], &mut out[..middle]);
    let right = divided(session, plane, side, &sorted[middle..], &mut out[middle..]);
    let [i, j] = tangent(session, plane, side, &out[..left], &out[middle..middle + right]);
    out.copy_within(middle + j..middle + right, i + 1);
    i + 1 + right - j
}

/// The indices of the two vertices at which the common tangent of two chains touches them. All vertices of the first
/// chain come before those of the second. Each step passes a vertex for good.
pub(super) fn tangent(
    session: &dyn Predicates,
    plane: Plane,
    side: Side,
    left: &[Vertex],
    right: &[Vertex],
) -> [usize; 2] {
    let [mut i, mut j] = [left.len() - 1, 0];
    loop {
        let before = [i, j];
        while i > 0 && !keeps(session, plane, side, [left[i - 1], left[i], right[j]]) {
            i -= 1;
        }
        while j + 1 < right.len() && !keeps(session, plane, side, [left[i], right[j], right[j + 1]]) {
            j += 1;
        }
        if [i, j] == before {
            return [i, j];
        }
    }
}

/// Both chains as one polygon, counterclockwise from the first vertex on.
///
/// `None` if the chains share a vertex besides their ends: then they are not the two sides of a polygon.
pub(super) fn polygon(sorted: &[Vertex], lower: &[Vertex], upper: &[Vertex]) -> Option<Vec<Vertex>> {
    let (Some(&first), Some(&last)) = (sorted.first(), sorted.last()) else { return Some(Vec::new()) };
    // Both chains are in the order of `sorted`.
    let (mut below, mut above) = (lower.iter().peekable(), upper.iter().peekable());
    for &v in sorted {
        let both = [below.next_if_eq(&&v).is_some(), above.next_if_eq(&&v).is_some()];
        if both == [true; 2] && v != first && v != last {
            return None;
        }
    }
    let back = upper.iter().rev().skip(1).take(upper.len().saturating_sub(2));
    Some(lower.iter().chain(back).copied().collect())
}
