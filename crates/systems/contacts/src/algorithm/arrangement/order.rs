//! The order of merged points along an edge.

use std::cmp::Ordering;

use predicament_predicates::{Axis, Dimension, Scene, Vertex};
use rug::Rational;

/// A merged point on an edge, with its registration there.
#[derive(Clone, Copy, Debug)]
pub(super) struct On {
    /// The vertex of the other complex, if the point is one.
    pub(super) vertex: Option<Vertex>,
    /// The registered weight of the edge's second end.
    pub(super) weight: f64,
    /// The merged point.
    pub(super) point: usize,
}

/// The points in their order from one end to the other.
///
/// A weight is a rounded number: two vertices on an edge can be so close that their weights are equal or in the wrong
/// order. So a vertex that is exactly on the edge's line is ordered by its coordinates, any other point by its weight.
/// If points share a double, exact vertices come first, in their order, then the other points, the lower point first.
/// (The order of a crossing and a vertex at one double is not known.)
pub(super) fn along(scene: &Scene, ends: [Vertex; 2], points: Vec<On>) -> Vec<usize> {
    if points.len() < 2 {
        return points.into_iter().map(|on| on.point).collect();
    }
    let mut placed: Vec<Place> = points.iter().map(|on| Place::of(scene, ends, on)).collect();
    placed.sort_by(Place::order);
    placed.into_iter().map(|place| place.point).collect()
}

/// A position along an edge: 0 is the first end, 1 the second.
struct Place {
    /// The exact position, rounded to a double, or the weight.
    weight: f64,
    exact: Option<Rational>,
    point: usize,
}

impl Place {
    fn of(scene: &Scene, ends: [Vertex; 2], on: &On) -> Place {
        let exact = on.vertex.and_then(|vertex| fraction(scene, ends, vertex));
        // Rounding to nearest keeps the order; so does GMP's own conversion, which rounds towards zero.
        let weight = exact.as_ref().map_or(on.weight, Rational::to_f64);
        // (Negative zero becomes zero.)
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

/// The position of a vertex along an edge, if it is exactly on the edge's line; `None` for an edge without length.
fn fraction(scene: &Scene, [a, b]: [Vertex; 2], p: Vertex) -> Option<Rational> {
    let axes: &[Axis] = match scene.dimension() {
        Dimension::Two => &[Axis::X, Axis::Y],
        Dimension::Three => &[Axis::X, Axis::Y, Axis::Z],
    };
    let at = |v, axis| Rational::from_f64(scene.coordinate(axis, v)).expect("coordinates are finite");
    let from_a = |v: Vertex| -> Vec<Rational> { axes.iter().map(|&axis| at(v, axis) - at(a, axis)).collect() };
    let (u, w) = (from_a(b), from_a(p));
    // The first nonzero component of the line's direction; a vector along the line is a multiple of the direction.
    let along = u.iter().position(|x| x.cmp0() != Ordering::Equal)?;
    let fraction = Rational::from(&w[along] / &u[along]);
    u.iter().zip(&w).all(|(u, w)| Rational::from(u * &fraction) == *w).then_some(fraction)
}
