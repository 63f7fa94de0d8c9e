//! The lengths of a mesh's primitives, from which tolerances are computed.
//!
//! `predicament-arithmetic` has a similar function. This copy keeps the exact checks of meshes independent of the
//! arithmetic under test.

use predicament_predicates::{Axis, Dimension, Scene, Vertex};

/// The largest side of the bounding box of an edge, rounded up so that no exact coordinate difference is larger; zero
/// without edges.
pub(crate) fn longest(scene: &Scene, edges: impl Iterator<Item = [Vertex; 2]>) -> f64 {
    let axes: &[Axis] = match scene.dimension() {
        Dimension::Two => &[Axis::X, Axis::Y],
        Dimension::Three => &[Axis::X, Axis::Y, Axis::Z],
    };
    let extent = |[a, b]: [Vertex; 2]| {
        let along = |&axis: &Axis| distance_up(scene.coordinate(axis, a), scene.coordinate(axis, b));
        axes.iter().map(along).fold(0.0, f64::max)
    };
    edges.map(extent).fold(0.0, f64::max)
}

/// |a − b|, rounded up; infinite if no double is large enough.
fn distance_up(a: f64, b: f64) -> f64 {
    let (high, low) = (a.max(b), a.min(b));
    let distance = high - low;
    // The rounding error is a double (Knuth's two-sum), or NaN after an overflow.
    let seen = distance - high;
    let rounded_off = (high - (distance - seen)) - (low + seen);
    if rounded_off > 0.0 { distance.next_up() } else { distance }
}
