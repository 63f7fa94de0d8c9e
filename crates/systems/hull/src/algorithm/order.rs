//! Vertices in lexicographic order, one for each place.

use predicament_predicates::{Axis, Predicates, Sign, Vertex};

use predicament_grid::sort::sort_by_sign;

/// The order of two vertices by the first of these axes on which they differ.
pub(super) fn lexicographic(session: &dyn Predicates, axes: &[Axis], a: Vertex, b: Vertex) -> Sign {
    let signs = axes.iter().map(|&axis| session.compare(axis, a, b));
    signs.into_iter().find(|&sign| sign != Sign::Zero).unwrap_or(Sign::Zero)
}

/// The vertices in lexicographic order; of several that are equal on all axes, the one with the smallest index.
///
/// The vertices are sorted by their coordinates first. Without perturbation, one comparison for each pair of neighbours
/// then confirms the order.
pub(super) fn sorted(session: &dyn Predicates, axes: &[Axis], vertices: &[Vertex]) -> Vec<Vertex> {
    let scene = session.scene();
    let key = |v: Vertex| {
        let mut key = [0.0; 3];
        for (place, &axis) in key.iter_mut().zip(axes) {
            *place = scene.coordinate(axis, v);
        }
        (key, v)
    };
    let mut keyed: Vec<([f64; 3], Vertex)> = vertices.iter().map(|&v| key(v)).collect();
    // Coordinates are finite, and zeros of either sign are equal.
    keyed.sort_unstable_by(|(a, v), (b, w)| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal).then(v.cmp(w)));
    let mut sorted: Vec<Vertex> = keyed.into_iter().map(|(_, v)| v).collect();
    sort_by_sign(&mut sorted, |a, b| lexicographic(session, axes, a, b));
    // The sort is stable: of equal vertices, the smallest index comes first.
    sorted.dedup_by(|next, kept| lexicographic(session, axes, *next, *kept) == Sign::Zero);
    sorted
}
