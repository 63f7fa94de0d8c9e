//! Convex hulls of points of the plane.

use predicament_predicates::{Plane, Predicates, Vertex};

use super::chains::{Side, divided, monotone, polygon};
use super::{Contradiction, Hull2, interior, order};

/// How the hull of points of the plane is found.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub enum PlaneMethod {
    /// Points inside of an octagon are thrown away, the others sorted, and two chains made of them from left to right
    /// (Andrew's monotone chain).
    #[default]
    Chain,
    /// The points are sorted; the chains of both halves are joined by their common tangent.
    Divide,
}

/// The convex hull of the scene's vertices.
#[must_use]
pub fn hull2d(session: &dyn Predicates, method: PlaneMethod) -> Hull2 {
    let vertices = match method {
        PlaneMethod::Chain => interior::outer(session),
        PlaneMethod::Divide => session.scene().vertices().collect(),
    };
    flat(session, Plane::Xy, method, &vertices)
}

/// The convex hull of vertices seen in a coordinate plane.
pub(super) fn flat(session: &dyn Predicates, plane: Plane, method: PlaneMethod, vertices: &[Vertex]) -> Hull2 {
    let sorted = order::sorted(session, &plane.axes(), vertices);
    let [lower, upper] = [Side::Lower, Side::Upper].map(|side| match method {
        PlaneMethod::Chain => monotone(session, plane, side, &sorted),
        PlaneMethod::Divide => {
            let mut chain = sorted.clone();
            let length = divided(session, plane, side, &sorted, &mut chain);
            chain.truncate(length);
            chain
        }
    });
    match polygon(&sorted, &lower, &upper) {
        Some(vertices) => Hull2 { vertices, broken: None },
        None => Hull2 { vertices: lower, broken: Some(Contradiction::Chains) },
    }
}
