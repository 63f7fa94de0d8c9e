//! The order of triangles around an edge that they share.

use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use predicament_grid::sort::sort_by_sign;

/// Sorts items by the angle of their vertices around an axis, counterclockwise as seen from its first vertex, from the first item on.
///
/// All vertices may be of one mesh, which a perturbation may leave as it is: two on one plane with the axis are on one side of it or on two.
pub(super) fn sort<T: Copy>(session: &dyn Predicates, [a, b]: [Vertex; 2], items: &mut [(Vertex, T)]) {
    let Some(&(first, _)) = items.first() else { return };
    // The half turn that a vertex is in, from the first one on: at it, before the opposite one, at that, after it.
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
        // Counterclockwise from v comes w: v is first.
        std::cmp::Ordering::Equal => -session.orient3d(a, b, v, w),
    });
    for (item, (_, sorted)) in items.iter_mut().zip(known) {
        *item = sorted;
    }
}

/// Of two vertices on one plane with an axis, whether these are on two sides of it.
fn is_opposite(session: &dyn Predicates, [a, b]: [Vertex; 2], v: Vertex, w: Vertex) -> bool {
    v != w
        && [Plane::Xy, Plane::Yz, Plane::Zx].into_iter().any(|plane| {
            let sides = [v, w].map(|v| session.orient2d(plane, a, b, v));
            !sides[0].is_zero() && sides[0] == -sides[1]
        })
}
