//! Contacts by signs: what the trait's contact questions mean for a session
//! whose zero is no band.
//!
//! Each question comes after those about its sub-pairs, and is asked only where
//! none of them was answered yes. With exact signs the answers then sort the
//! common points of two closed simplices by their carriers, the lowest
//! dimensions first; with signs that are never zero only pairs of full
//! dimension can meet. Decisions are by signs alone; weights are plain
//! floating-point values and decide nothing.

use crate::{Axis, Dimension, Plane, Predicates, Scene, Sign, Vertex};

const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];

fn axes(scene: &Scene) -> &'static [Axis] {
    match scene.dimension() {
        Dimension::Two => &[Axis::X, Axis::Y],
        Dimension::Three => &[Axis::X, Axis::Y, Axis::Z],
    }
}

fn planes(scene: &Scene) -> &'static [Plane] {
    match scene.dimension() {
        Dimension::Two => &PLANES[..1],
        Dimension::Three => &PLANES,
    }
}

/// All coordinates are equal.
pub(crate) fn vertex_vertex<S: Predicates + ?Sized>(session: &S, a: Vertex, p: Vertex) -> bool {
    axes(session.scene()).iter().all(|&axis| session.compare(axis, a, p) == Sign::Zero)
}

/// Collinear in every projection, and between the ends along the first axis that tells them apart.
pub(crate) fn edge_vertex<S: Predicates + ?Sized>(session: &S, [a, b]: [Vertex; 2], p: Vertex) -> Option<f64> {
    let scene = session.scene();
    if planes(scene).iter().any(|&plane| session.orient2d(plane, a, b, p) != Sign::Zero) {
        return None;
    }
    let (axis, forward) = axes(scene)
        .iter()
        .map(|&axis| (axis, session.compare(axis, b, a)))
        .find(|&(_, forward)| forward != Sign::Zero)?;
    let inside = session.compare(axis, p, a) == forward && session.compare(axis, b, p) == forward;
    inside.then(|| {
        let [a, b, p] = [a, b, p].map(|v| scene.coordinate(axis, v));
        (p - a) / (b - a)
    })
}

/// Four turns in the plane; in space the same in a projection, where all four
/// vertices are in one plane.
pub(crate) fn edge_edge<S: Predicates + ?Sized>(session: &S, e: [Vertex; 2], f: [Vertex; 2]) -> Option<[f64; 2]> {
    let plane = match session.scene().dimension() {
        Dimension::Two => Plane::Xy,
        Dimension::Three => {
            let ([a, b], [p, q]) = (e, f);
            if session.orient3d(a, b, p, q) != Sign::Zero {
                return None;
            }
            // Where the three are collinear, p is outside the edge, and so is all of f that meets its line.
            PLANES.into_iter().find(|&plane| session.orient2d(plane, a, b, p) != Sign::Zero)?
        }
    };
    crosses(session, plane, e, f).then(|| crossing_weights(session.scene(), plane, e, f))
}

/// Whether each edge's ends are strictly on both sides of the other.
fn crosses<S: Predicates + ?Sized>(session: &S, plane: Plane, [a, b]: [Vertex; 2], [p, q]: [Vertex; 2]) -> bool {
    let opposite = |left: Sign, right: Sign| left != Sign::Zero && left == -right;
    opposite(session.orient2d(plane, a, b, p), session.orient2d(plane, a, b, q))
        && opposite(session.orient2d(plane, p, q, a), session.orient2d(plane, p, q, b))
}

/// Whether the vertex is strictly on the same side of all three edges.
fn encloses<S: Predicates + ?Sized>(session: &S, plane: Plane, [a, b, c]: [Vertex; 3], p: Vertex) -> bool {
    let side = session.orient2d(plane, a, b, p);
    side != Sign::Zero && side == session.orient2d(plane, b, c, p) && side == session.orient2d(plane, c, a, p)
}

/// Three turns in the plane; in space the same in a projection, where the vertex is in the triangle's plane.
pub(crate) fn triangle_vertex<S: Predicates + ?Sized>(session: &S, t: [Vertex; 3], p: Vertex) -> Option<[f64; 3]> {
    let [a, b, c] = t;
    let plane = match session.scene().dimension() {
        Dimension::Two => Plane::Xy,
        Dimension::Three => {
            if session.orient3d(a, b, c, p) != Sign::Zero {
                return None;
            }
            PLANES.into_iter().find(|&plane| session.orient2d(plane, a, b, c) != Sign::Zero)?
        }
    };
    encloses(session, plane, t, p).then(|| {
        let [a, b, c, p] = [a, b, c, p].map(|v| session.scene().point2(plane, v));
        parts([area(p, b, c), area(a, p, c), area(a, b, p)])
    })
}

/// Five volumes: the edge's ends on both sides of the triangle, and its line through the inside.
pub(crate) fn triangle_edge<S: Predicates + ?Sized>(
    session: &S,
    [a, b, c]: [Vertex; 3],
    [p, q]: [Vertex; 2],
) -> Option<([f64; 3], f64)> {
    let below = session.orient3d(a, b, c, p);
    if below == Sign::Zero || below != -session.orient3d(a, b, c, q) {
        return None;
    }
    let side = session.orient3d(p, q, a, b);
    let meets = side != Sign::Zero && side == session.orient3d(p, q, b, c) && side == session.orient3d(p, q, c, a);
    meets.then(|| {
        let [a, b, c, p, q] = [a, b, c, p, q].map(|v| session.scene().point3(v));
        let [at_p, at_q] = [volume(a, b, c, p), volume(a, b, c, q)];
        let weights = parts([volume(p, q, b, c), volume(p, q, c, a), volume(p, q, a, b)]);
        (weights, at_p / (at_p - at_q))
    })
}

/// Four volumes of one sign.
pub(crate) fn tetrahedron_vertex<S: Predicates + ?Sized>(
    session: &S,
    [a, b, c, d]: [Vertex; 4],
    p: Vertex,
) -> Option<[f64; 4]> {
    let side = session.orient3d(a, b, c, p);
    let inside = side != Sign::Zero
        && side == session.orient3d(a, b, p, d)
        && side == session.orient3d(a, p, c, d)
        && side == session.orient3d(p, b, c, d);
    inside.then(|| {
        let [a, b, c, d, p] = [a, b, c, d, p].map(|v| session.scene().point3(v));
        parts([volume(p, b, c, d), volume(a, p, c, d), volume(a, b, p, d), volume(a, b, c, p)])
    })
}

fn crossing_weights(scene: &Scene, plane: Plane, [a, b]: [Vertex; 2], [p, q]: [Vertex; 2]) -> [f64; 2] {
    let [a, b, p, q] = [a, b, p, q].map(|v| scene.point2(plane, v));
    let [at_a, at_b] = [area(a, p, q), area(b, p, q)];
    let [at_p, at_q] = [area(p, a, b), area(q, a, b)];
    [at_a / (at_a - at_b), at_p / (at_p - at_q)]
}

/// Each over the sum of all.
fn parts<const N: usize>(of: [f64; N]) -> [f64; N] {
    let sum: f64 = of.iter().sum();
    of.map(|part| part / sum)
}

fn area([ax, ay]: [f64; 2], [bx, by]: [f64; 2], [cx, cy]: [f64; 2]) -> f64 {
    (ax - cx) * (by - cy) - (ay - cy) * (bx - cx)
}

fn volume(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> f64 {
    let [a, b, c] = [a, b, c].map(|p| [p[0] - d[0], p[1] - d[1], p[2] - d[2]]);
    (a[1] * b[2] - a[2] * b[1]) * c[0] + (a[2] * b[0] - a[0] * b[2]) * c[1] + (a[0] * b[1] - a[1] * b[0]) * c[2]
}
