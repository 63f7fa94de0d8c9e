//! The order of points along an edge.

use predicament_grid::sort::sort_by_sign;
use predicament_predicates::{Axis, Predicates, Vertex};

/// The axis along which an edge of input vertices is longest, and true if the edge goes up there.
pub(super) fn longest(session: &dyn Predicates, ends: [Vertex; 2]) -> (Axis, bool) {
    let [from, to] = ends.map(|v| session.scene().point3(v));
    let extent = |axis: Axis| (to[axis.index()] / 2.0 - from[axis.index()] / 2.0).abs();
    let longer = |best: Axis, axis: Axis| if extent(axis) > extent(best) { axis } else { best };
    let axis = [Axis::Y, Axis::Z].into_iter().fold(Axis::X, longer);
    (axis, from[axis.index()] < to[axis.index()])
}

/// Sorts points on an edge from its first end to its second, along the axis in which the edge is longest.
pub(super) fn sort_along<T: Copy>(
    session: &dyn Predicates,
    ends: [Vertex; 2],
    points: &mut [T],
    vertex: impl Fn(T) -> Vertex,
) {
    let (axis, is_up) = longest(session, ends);
    sort_by_sign(points, |a, b| {
        let sign = session.compare(axis, vertex(a), vertex(b));
        if is_up { sign } else { -sign }
    });
}
