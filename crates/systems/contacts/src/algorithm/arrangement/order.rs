//! The order of merged points along an edge.

use std::cmp::Ordering;

use predicament_predicates::{Axis, Dimension, Scene, Vertex};
use rug::Rational;

/// A merged point on an edge, and how it was registered there.
#[derive(Clone, Copy, Debug)]
pub(super) struct On {
    /// The vertex of the other complex, if it is one.
    pub(super) vertex: Option<Vertex>,
    /// The registered weight of the edge's second end.
    pub(super) weight: f64,
    /// The merged point.
    pub(super) point: usize,
}

/// The points in their order from one end to the other.
///
/// A weight is a rounded number: two vertices on an edge can be nearer to each
/// other than weights tell, and then it has them in one place or the wrong way
/// round. So a vertex that is exactly on the edge's line is where its
/// coordinates say. All else is where it was registered. Of what is at one
/// double, exact vertices come first, in their order, then the others, the lower
/// point first. (How a crossing and a vertex at one double lie is not known.)
pub(super) fn along(scene: &Scene, ends: [Vertex; 2], points: Vec<On>) -> Vec<usize> {
    if points.len() < 2 {
        return points.into_iter().map(|on| on.point).collect();
    }
    let mut placed: Vec<Place> = points.iter().map(|on| Place::of(scene, ends, on)).collect();
    placed.sort_by(Place::order);
    placed.into_iter().map(|place| place.point).collect()
}

/// A place along an edge: 0 is the first end, 1 the second.
struct Place {
    /// The double next to where it is exactly, or the weight.
    weight: f64,
    exact: Option<Rational>,
    point: usize,
}

impl Place {
    fn of(scene: &Scene, ends: [Vertex; 2], on: &On) -> Place {
        let exact = on.vertex.and_then(|vertex| fraction(scene, ends, vertex));
        // Rounding to the nearest keeps the order; GMP's own conversion rounds towards zero, which does as well.
        let weight = exact.as_ref().map_or(on.weight, Rational::to_f64);
        // (Negative zero is zero.)
        Place { weight: weight + 0.0, exact, point: on.point }
    }

    fn order(&self, other: &Place) -> Ordering {
        let within = match (&self.exact, &other.exact) {
            (Some(at), Some(other)) => at.cmp(other),
            (at, other) => other.is_some().cmp(&at.is_some()),
        };
        self.weight.total_cmp(&other.weight).then(within).then(self.point.cmp(&other.point))
    }
}

/// How far along an edge the vertex is, if it is exactly on the edge's line.
/// An edge without length has none.
fn fraction(scene: &Scene, [a, b]: [Vertex; 2], p: Vertex) -> Option<Rational> {
    let axes: &[Axis] = match scene.dimension() {
        Dimension::Two => &[Axis::X, Axis::Y],
        Dimension::Three => &[Axis::X, Axis::Y, Axis::Z],
    };
    let at = |v, axis| Rational::from_f64(scene.coordinate(axis, v)).expect("coordinates are finite");
    let from_a = |v: Vertex| -> Vec<Rational> { axes.iter().map(|&axis| at(v, axis) - at(a, axis)).collect() };
    let (u, w) = (from_a(b), from_a(p));
    // Of the line's direction one number is not zero, and what is along it is a multiple of it.
    let along = u.iter().position(|x| x.cmp0() != Ordering::Equal)?;
    let fraction = Rational::from(&w[along] / &u[along]);
    u.iter().zip(&w).all(|(u, w)| Rational::from(u * &fraction) == *w).then_some(fraction)
}
