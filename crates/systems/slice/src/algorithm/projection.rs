//! The coordinate plane in which three vertices turn, and the normal of their plane.

use predicament_predicates::{Plane, Predicates, Scene, Sign, Vertex};

/// A coordinate plane in which three vertices turn, and true if they turn clockwise there.
pub(super) fn seen(session: &dyn Predicates, support: [Vertex; 3]) -> Option<(Plane, bool)> {
    let [a, b, c] = support;
    let normal = normal(session.scene(), support);
    let mut planes = [(Plane::Yz, normal[0]), (Plane::Zx, normal[1]), (Plane::Xy, normal[2])];
    // Any plane will do, if the vertices turn there.
    planes.sort_by(|p, q| q.1.abs().total_cmp(&p.1.abs()));
    planes.into_iter().find_map(|(plane, _)| match session.orient2d(plane, a, b, c) {
        Sign::Zero => None,
        sign => Some((plane, sign == Sign::Negative)),
    })
}

/// The approximate normal of a plane of input vertices.
pub(super) fn normal(scene: &Scene, plane: [Vertex; 3]) -> [f64; 3] {
    let [a, b, c] = plane.map(|v| scene.point3(v));
    let minus = |p: [f64; 3], q: [f64; 3]| [0, 1, 2].map(|i| p[i] - q[i]);
    cross(minus(b, a), minus(c, a))
}

pub(super) fn cross(u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}
