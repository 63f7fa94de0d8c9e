//! Intersection of an axis-parallel ray with a triangle.

use predicament_grid::two_level::Ray;
use predicament_predicates::{Axis, Plane, Predicates, Sign, Vertex};

/// The direction of an axis-parallel ray, as predicates use it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Direction {
    /// The plane across the ray; the ray goes along its normal or against it.
    pub(super) plane: Plane,
    /// The sign of `orient3d` of a triangle that turns left in that plane, and a point from which the ray meets it.
    before: Sign,
}

impl Direction {
    #[inline(always)]
    pub(super) fn of(ray: Ray) -> Direction {
        let plane = [Plane::Yz, Plane::Zx, Plane::Xy][ray.axis];
        // A point below a triangle that is seen counterclockwise from above has a positive sign.
        Direction { plane, before: if ray.is_up { Sign::Positive } else { Sign::Negative } }
    }

    /// True if the ray goes to larger coordinates.
    #[inline(always)]
    pub(super) fn is_up(self) -> bool {
        self.before == Sign::Positive
    }
}

/// The way in which a ray meets a triangle.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Stab {
    /// The ray misses the triangle.
    Missed,
    /// The point itself is on the triangle.
    On,
    /// Not known: a sign is zero within a band.
    Unsure,
    /// The ray passes the triangle, from back to front or from front to back.
    Passed {
        /// True if the point is behind the triangle.
        from_behind: bool,
    },
}

/// Decides how the ray from `q` meets the triangle a, b, c; as seen along the ray, the point is in the triangle's box.
///
/// If `is_near`, the point is also in the box along the ray; otherwise the point is not on the triangle. `turn` is
/// `orient2d` in the plane across the ray, of an edge and q.
#[inline]
pub(super) fn stab<P: Predicates + ?Sized>(
    session: &P,
    direction: Direction,
    [a, b, c]: [Vertex; 3],
    q: Vertex,
    is_near: bool,
    mut turn: impl FnMut(Vertex, Vertex) -> Sign,
) -> Stab {
    let first = turn(a, b);
    let second = turn(b, c);
    if first * second == Sign::Negative {
        return Stab::Missed;
    }
    let third = turn(c, a);
    let turns = if first == Sign::Zero { second } else { first };
    if third * turns == Sign::Negative {
        return Stab::Missed;
    }
    if first == Sign::Zero || second == Sign::Zero || third == Sign::Zero {
        return beside(session, direction, [a, b, c], q, [first, second, third], is_near);
    }
    passed(session, direction, [a, b, c], q, turns)
}

/// Decides for a triangle that is over or under the point.
fn passed<P: Predicates + ?Sized>(
    session: &P,
    direction: Direction,
    [a, b, c]: [Vertex; 3],
    q: Vertex,
    turns: Sign,
) -> Stab {
    let side = session.orient3d(a, b, c, q);
    if side == Sign::Zero {
        return Stab::On;
    }
    let is_before = (side == turns) == direction.is_up();
    if is_before { Stab::Passed { from_behind: side == Sign::Positive } } else { Stab::Missed }
}

/// The position of a triangle's box along a ray, as seen from a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Way {
    /// True if the box holds the point, or is within the reach of it.
    pub(super) is_near: bool,
    /// `Some(true)` if the whole box is further along the ray than the point, `Some(false)` if it is less far;
    /// otherwise `None`.
    pub(super) ahead: Option<bool>,
}

/// Decides like [`stab`], for a session whose zeros come from a tolerance band: the true sign may be any.
///
/// Signs that are not zero are right, and so is every answer except `Unsure`.
pub(super) fn stab_in_band<P: Predicates + ?Sized>(
    session: &P,
    direction: Direction,
    corners: [Vertex; 3],
    q: Vertex,
    way: Way,
) -> Stab {
    let [a, b, c] = corners;
    let turns = [[a, b], [b, c], [c, a]].map(|[u, v]| session.orient2d(direction.plane, u, v, q));
    if turns.contains(&Sign::Positive) && turns.contains(&Sign::Negative) {
        return Stab::Missed;
    }
    let side = session.orient3d(a, b, c, q);
    if way.is_near && side == Sign::Zero && is_within(session, corners, q) {
        return Stab::On;
    }
    // The turn of the triangle, if the ray passes it.
    let turn = turns.into_iter().find(|&turn| turn != Sign::Zero);
    let is_ahead = match (way.ahead, turn) {
        (Some(is_ahead), _) => is_ahead,
        (None, Some(turn)) if side != Sign::Zero => (side == turn) == direction.is_up(),
        _ => return Stab::Unsure,
    };
    match turn {
        _ if !is_ahead => Stab::Missed,
        Some(turn) if !turns.contains(&Sign::Zero) => {
            Stab::Passed { from_behind: (turn == Sign::Positive) == direction.is_up() }
        }
        _ => Stab::Unsure,
    }
}

/// Decides when the projected point is at least on the line of an edge.
#[cold]
fn beside<P: Predicates + ?Sized>(
    session: &P,
    direction: Direction,
    corners: [Vertex; 3],
    q: Vertex,
    mut signs: [Sign; 3],
    is_near: bool,
) -> Stab {
    let [a, b, c] = corners;
    if is_near && session.orient3d(a, b, c, q) == Sign::Zero && is_within(session, corners, q) {
        return Stab::On;
    }
    let edges = [[a, b], [b, c], [c, a]];
    let [i, j] = direction.plane.axes();
    for (sign, edge) in signs.iter_mut().zip(edges) {
        if *sign == Sign::Zero {
            *sign = moved(session, [i, j], edge);
        }
    }
    let [first, second, third] = signs;
    if first == Sign::Zero || first != second || second != third {
        return Stab::Missed;
    }
    passed(session, direction, corners, q, first)
}

/// The turn of u, v and a point on their line that is moved by (ε, ε²): the first of ε (u − v)ⱼ and ε² (v − u)ᵢ that is
/// not zero.
fn moved<P: Predicates + ?Sized>(session: &P, [i, j]: [Axis; 2], [u, v]: [Vertex; 2]) -> Sign {
    match session.compare(j, u, v) {
        Sign::Zero => session.compare(i, v, u),
        sign => sign,
    }
}

/// True if a point of the triangle's plane is in the triangle, borders included.
fn is_within<P: Predicates + ?Sized>(session: &P, corners: [Vertex; 3], q: Vertex) -> bool {
    let [a, b, c] = corners;
    let is_on_one_side = |signs: [Sign; 3]| signs[0] != Sign::Zero && signs == [signs[0]; 3];
    let is_beside = |axis: Axis| is_on_one_side(corners.map(|v| session.compare(axis, v, q)));
    [Plane::Xy, Plane::Yz, Plane::Zx].into_iter().all(|plane| {
        let signs = [[a, b], [b, c], [c, a]].map(|[u, v]| session.orient2d(plane, u, v, q));
        !(signs.contains(&Sign::Positive) && signs.contains(&Sign::Negative))
        // (A triangle at one place has no turns.)
    }) && ![Axis::X, Axis::Y, Axis::Z].into_iter().any(is_beside)
}
