//! The choice of the coordinate plane in which a face in space is seen.

use predicament_predicates::{Dimension, Plane, Predicates, Sign, Vertex};

use super::view::View;

/// A coordinate plane in which the region of the loops has area, and true if the plane is reversed: if outer loops are
/// clockwise there. Returns `None` if all vertices are in line: then every such area is zero.
///
/// Candidates are the planes in which the turn at an extreme corner is not zero. If all vertices of the face have
/// coordinates, the result is the first candidate with the largest area in coordinates; otherwise it is the first
/// candidate. Sessions that never return zero need the coordinates: under them every plane has a turn at every corner.
/// They cannot choose a plane for constructed vertices; take the plane from the vertices' definitions.
pub fn projection<P: Predicates + ?Sized>(session: &P, loops: &[Vec<Vertex>]) -> Option<(Plane, bool)> {
    let mut planes = [Plane::Xy, Plane::Yz, Plane::Zx];
    if session.scene().dimension() == Dimension::Two {
        planes = [Plane::Xy; 3];
    } else if loops.iter().flatten().all(|v| !v.is_constructed()) {
        let areas = planes.map(|plane| area(session, plane, loops).abs());
        let mut order = [0, 1, 2];
        order.sort_by(|&i: &usize, &j: &usize| areas[j].total_cmp(&areas[i]));
        planes = order.map(|at| planes[at]);
    }
    planes.into_iter().find_map(|plane| match turn_at_first_place(session, plane, loops) {
        Sign::Zero => None,
        sign => Some((plane, sign == Sign::Negative)),
    })
}

/// Twice the area of the loops in a coordinate plane, rounded. It serves to choose a plane, not to decide anything.
fn area<P: Predicates + ?Sized>(session: &P, plane: Plane, loops: &[Vec<Vertex>]) -> f64 {
    let point = |v: Vertex| session.scene().point2(plane, v);
    let Some([x, y]) = loops.iter().flatten().next().map(|&v| point(v)) else { return 0.0 };
    let loop_area = |one: &Vec<Vertex>| -> f64 {
        let ends = one.iter().skip(1).chain(one.first());
        one.iter()
            .zip(ends)
            .map(|(&a, &b)| (point(a), point(b)))
            .map(|(a, b)| (a[0] - x) * (b[1] - y) - (a[1] - y) * (b[0] - x))
            .sum()
    };
    loops.iter().map(loop_area).sum()
}

/// The orientation of the outer loops: the turn from the last to the first edge around the first position of the sweep.
/// It is positive if the first edge, counterclockwise, leaves that position.
pub(super) fn turn_at_first_place<P: Predicates + ?Sized>(session: &P, plane: Plane, loops: &[Vec<Vertex>]) -> Sign {
    let view = View::new(session, plane, false);
    let all = || loops.iter().flatten().copied();
    let Some(first) = all().reduce(|a, b| if view.order(b, a) == Sign::Negative { b } else { a }) else {
        return Sign::Zero;
    };
    // The edges at this position: the vertex at the other end, and true if the edge leaves.
    let mut edges: Vec<(Vertex, bool)> = Vec::new();
    for one in loops {
        for at in 0..one.len() {
            let [a, b] = [one[at], one[(at + 1) % one.len()]];
            let [is_from, is_to] = [a, b].map(|v| view.order(first, v) == Sign::Zero);
            match (is_from, is_to) {
                (true, false) => edges.push((b, true)),
                (false, true) => edges.push((a, false)),
                _ => {}
            }
        }
    }
    let Some(&(mut lowest, mut leaves)) = edges.first() else { return Sign::Zero };
    for &(far, does_leave) in &edges[1..] {
        if view.turn(first, lowest, far) == Sign::Negative {
            (lowest, leaves) = (far, does_leave);
        }
    }
    let has_turn = edges.iter().any(|&(far, _)| view.turn(first, lowest, far) != Sign::Zero);
    match (has_turn, leaves) {
        (false, _) => Sign::Zero,
        (true, true) => Sign::Positive,
        (true, false) => Sign::Negative,
    }
}
