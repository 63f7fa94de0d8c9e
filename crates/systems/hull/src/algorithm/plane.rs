//! Convex hulls of points of the plane.

use predicament_predicates::{Plane, Predicates, Vertex};

use super::chains::{Side, divided, monotone, polygon};
use super::{Contradiction, Hull2, interior, order};

/// The methods for hulls in the plane.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub enum PlaneMethod {
    /// Andrew's monotone chain: drops points inside an octagon, sorts the others, and makes two chains of them from
    /// left to right.
    #[default]
    Chain,
    /// Divide and conquer: sorts the points, and joins the chains of both halves by their common tangent.
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

/// The convex hull of vertices projected to a coordinate plane.
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
