//! The choice of the loops that are holes: by rays from their first vertices, edge by edge.

use predicament_judge::boxes::{Boxes, Extent, extent};

use super::plane::Points;

/// For each loop, true if it is a hole: if an odd number of other loops surrounds it.
pub(super) fn holes(points: &Points, loops: &[Vec<usize>]) -> Vec<bool> {
    let edges: Vec<(usize, [usize; 2])> =
        loops.iter().enumerate().flat_map(|(at, one)| edges(one).map(move |edge| (at, edge))).collect();
    let boxes: Vec<Extent<2>> = edges.iter().map(|(_, edge)| extent(edge.map(|place| points.raw(place)))).collect();
    let boxes = Boxes::new(boxes);
    let mut near = Vec::new();
    let is_hole = |(at, one): (usize, &Vec<usize>)| {
        let Some((start, lower)) = first_edge(points, one) else { return false };
        let [x, y] = points.raw(start);
        boxes.near(&[[x, f64::NEG_INFINITY], [x, y]], 0.0, &mut near);
        let below = near.iter().filter(|&&edge| {
            let (other, edge) = edges[edge as usize];
            other != at && is_below(points, edge, start, lower)
        });
        !below.count().is_multiple_of(2)
    };
    loops.iter().enumerate().map(is_hole).collect()
}

/// The edges of a loop.
pub(super) fn edges(corners: &[usize]) -> impl Iterator<Item = [usize; 2]> + '_ {
    corners.iter().zip(corners.iter().cycle().skip(1)).map(|(&a, &b)| [a, b])
}

/// The leftmost vertex, and the other end of its lower edge.
fn first_edge(points: &Points, corners: &[usize]) -> Option<(usize, usize)> {
    let first = corners.iter().copied().min_by(|&a, &b| points.order(a, b))?;
    let far = edges(corners).flat_map(|[a, b]| [(a, b), (b, a)]);
    let far = far.filter(|&(a, b)| points.is_same_place(a, first) && !points.is_same_place(b, first)).map(|(_, b)| b);
    let lower = far.reduce(|a, b| if points.side(first, a, b).is_lt() { b } else { a })?;
    Some((first, lower))
}

/// True if an edge passes below a point, a little to the right of it. An edge through the point is below if it is below
/// the edge that begins there.
fn is_below(points: &Points, [a, b]: [usize; 2], start: usize, lower: usize) -> bool {
    let [left, right] = if points.order(a, b).is_lt() { [a, b] } else { [b, a] };
    // Half open: the edge begins at this x or before, and ends beyond it. Vertical edges never qualify.
    if points.order_x(left, start).is_gt() || points.order_x(right, start).is_le() {
        return false;
    }
    match points.side(left, right, start) {
        std::cmp::Ordering::Equal => points.side(left, right, lower).is_ge(),
        side => side.is_gt(),
    }
}
