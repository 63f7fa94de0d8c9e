//! A point and an edge, exactly.

use predicament_predicates::{Axis, Plane, Predicates, Sign, Vertex};

/// The position of a point as seen from an edge.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Place {
    /// Strictly below, with left ≤ x < right: an upward ray that leans right
    /// by less than every real distance crosses the edge.
    Below,
    /// Not on the edge, and not below it.
    Elsewhere,
    /// Between the ends.
    Between,
    /// At the first end, not at the second.
    AtFirst,
    /// At the second end, not at the first.
    AtSecond,
    /// At both ends: the edge has no length.
    AtBoth,
}

/// Decides the position of `p`; right for sessions that return exact signs.
pub(super) fn place<P: Predicates + ?Sized>(session: &P, [u, v]: [Vertex; 2], p: Vertex) -> Place {
    let of_u = session.compare(Axis::X, u, p);
    let of_v = session.compare(Axis::X, v, p);
    match (of_u, of_v) {
        (Sign::Zero, Sign::Zero) => match (session.compare(Axis::Y, u, p), session.compare(Axis::Y, v, p)) {
            (Sign::Zero, Sign::Zero) => Place::AtBoth,
            (Sign::Zero, _) => Place::AtFirst,
            (_, Sign::Zero) => Place::AtSecond,
            (of_u, of_v) if of_u == of_v => Place::Elsewhere,
            _ => Place::Between,
        },
        (of_u, of_v) if of_u == of_v => Place::Elsewhere,
        _ => {
            let (left, right) = if of_u < of_v { (u, v) } else { (v, u) };
            match session.orient2d(Plane::Xy, left, right, p) {
                Sign::Zero if of_u.is_zero() => Place::AtFirst,
                Sign::Zero if of_v.is_zero() => Place::AtSecond,
                Sign::Zero => Place::Between,
                Sign::Negative if of_u.max(of_v) == Sign::Positive => Place::Below,
                _ => Place::Elsewhere,
            }
        }
    }
}

#[cfg(test)]
mod tests;
