//! The order of triangles around a shared edge.

use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use predicament_grid::sort::sort_by_sign;

/// Sorts items by the angle of their vertices around an axis, counterclockwise as seen from its first vertex, starting
/// at the first item.
///
/// All vertices may be of one mesh, which a perturbation may not move: two vertices in one plane with the axis are on
/// the same side of it or on opposite sides.
pub(super) fn sort<T: Copy>(session: &dyn Predicates, [a, b]: [Vertex; 2], items: &mut [(Vertex, T)]) {
    let Some(&(first, _)) = items.first() else { return };
    // The position of a vertex relative to the first: at it, before the opposite direction, at that, or after it.
    let quarter = |v: Vertex| match session.orient3d(a, b, first, v) {
        Sign::Positive => 1,
        Sign::Negative => 3,
        Sign::Zero if is_opposite(session, [a, b], first, v) => 2,
        Sign::Zero => 0,
    };
    let mut known: Vec<(u8, (Vertex, T))> = items.iter().map(|&item| (quarter(item.0), item)).collect();
    sort_by_sign(&mut known, |(i, (v, _)), (j, (w, _))| match i.cmp(&j) {
        std::cmp::Ordering::Less => Sign::Negative,
        std::cmp::Ordering::Greater => Sign::Positive,
        // If w is counterclockwise from v, v is first.
        std::cmp::Ordering::Equal => -session.orient3d(a, b, v, w),
    });
    for (item, (_, sorted)) in items.iter_mut().zip(known) {
        *item = sorted;
    }
}

/// True if two vertices in one plane with an axis are on opposite sides of it.
fn is_opposite(session: &dyn Predicates, [a, b]: [Vertex; 2], v: Vertex, w: Vertex) -> bool {
    v != w
        && [Plane::Xy, Plane::Yz, Plane::Zx].into_iter().any(|plane| {
            let sides = [v, w].map(|v| session.orient2d(plane, a, b, v));
            !sides[0].is_zero() && sides[0] == -sides[1]
        })
}

/// True if two vertices are in one half-plane that ends at an axis.
pub(super) fn is_along(session: &dyn Predicates, [a, b]: [Vertex; 2], v: Vertex, w: Vertex) -> bool {
    session.orient3d(a, b, v, w).is_zero() && !is_opposite(session, [a, b], v, w)
}
