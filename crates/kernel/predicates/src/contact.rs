//! Contacts by signs: the default bodies of the contact queries, for sessions whose zero is not a band.
//!
//! Each pair is queried after its sub-pairs, and only if none of them was registered. With exact signs the answers then
//! sort the common points of two closed simplices by their carriers, the lowest dimensions first. With signs that are
//! never zero only pairs of full dimension can meet. Signs alone make decisions; weights are plain floating-point
//! values. Weights lie in [0, 1] and add up to one except for rounding. If all floating-point values are zero, as when
//! a perturbation has decided, the weights are equal.

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

/// Returns true if all coordinates are equal.
pub(crate) fn vertex_vertex<S: Predicates + ?Sized>(session: &S, a: Vertex, p: Vertex) -> bool {
    axes(session.scene()).iter().all(|&axis| session.compare(axis, a, p) == Sign::Zero)
}

/// The position of p on the edge, or `None`.
///
/// p must be collinear in every projection, and between the ends along the first axis that separates the ends.
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
        let [[a], [b], [p]] = scaled([a, b, p].map(|v| [scene.coordinate(axis, v)]));
        (p - a) / (b - a)
    })
}

/// The crossing of two edges by four turns in the plane, or `None`.
///
/// In space the turns are taken in a projection, if all four vertices are coplanar.
pub(crate) fn edge_edge<S: Predicates + ?Sized>(session: &S, e: [Vertex; 2], f: [Vertex; 2]) -> Option<[f64; 2]> {
    let plane = match session.scene().dimension() {
        Dimension::Two => Plane::Xy,
        Dimension::Three => {
            let ([a, b], [p, q]) = (e, f);
            if session.orient3d(a, b, p, q) != Sign::Zero {
                return None;
            }
            // If the three are collinear here, p is outside the edge, and so are all points of f on the edge's line.
            PLANES.into_iter().find(|&plane| session.orient2d(plane, a, b, p) != Sign::Zero)?
        }
    };
    crosses(session, plane, e, f).then(|| crossing_weights(session.scene(), plane, e, f))
}

/// Returns true if the ends of each edge are strictly on both sides of the other edge.
fn crosses<S: Predicates + ?Sized>(session: &S, plane: Plane, [a, b]: [Vertex; 2], [p, q]: [Vertex; 2]) -> bool {
    let opposite = |left: Sign, right: Sign| left != Sign::Zero && left == -right;
    opposite(session.orient2d(plane, a, b, p), session.orient2d(plane, a, b, q))
        && opposite(session.orient2d(plane, p, q, a), session.orient2d(plane, p, q, b))
}

/// Returns true if the vertex is strictly on the same side of all three edges.
fn encloses<S: Predicates + ?Sized>(session: &S, plane: Plane, [a, b, c]: [Vertex; 3], p: Vertex) -> bool {
    let side = session.orient2d(plane, a, b, p);
    side != Sign::Zero && side == session.orient2d(plane, b, c, p) && side == session.orient2d(plane, c, a, p)
}

/// The position of the vertex in the triangle by three turns in the plane, or `None`.
///
/// In space the turns are taken in a projection, if the vertex is in the triangle's plane.
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
        let [a, b, c, p] = scaled([a, b, c, p].map(|v| session.scene().point2(plane, v)));
        parts([area(p, b, c), area(a, p, c), area(a, b, p)])
    })
}

/// The point where the edge pierces the triangle, by five volumes, or `None`.
///
/// The edge's ends must be on both sides of the triangle, and the edge's line must pass through the inside.
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
        let [a, b, c, p, q] = scaled([a, b, c, p, q].map(|v| session.scene().point3(v)));
        let [from_p, _] = parts([volume(a, b, c, p), volume(a, b, c, q)]);
        (parts([volume(p, q, b, c), volume(p, q, c, a), volume(p, q, a, b)]), from_p)
    })
}

/// The position of the vertex in the tetrahedron if four volumes have one sign, or `None`.
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
        let [a, b, c, d, p] = scaled([a, b, c, d, p].map(|v| session.scene().point3(v)));
        parts([volume(p, b, c, d), volume(a, p, c, d), volume(a, b, p, d), volume(a, b, c, p)])
    })
}

fn crossing_weights(scene: &Scene, plane: Plane, [a, b]: [Vertex; 2], [p, q]: [Vertex; 2]) -> [f64; 2] {
    let [a, b, p, q] = scaled([a, b, p, q].map(|v| scene.point2(plane, v)));
    let [[from_a, _], [from_p, _]] = [parts([area(a, p, q), area(b, p, q)]), parts([area(p, a, b), area(q, a, b)])];
    [from_a, from_p]
}

/// The magnitude of each value over the sum of magnitudes.
///
/// The signs are known from the predicates. A value computed with the wrong sign is nearer to the truth without it.
#[allow(clippy::cast_precision_loss)] // N is 2, 3 or 4
fn parts<const N: usize>(of: [f64; N]) -> [f64; N] {
    let of = of.map(f64::abs);
    let sum: f64 = of.iter().sum();
    if sum == 0.0 { [1.0 / N as f64; N] } else { of.map(|part| part / sum) }
}

/// The points divided by a power of two, so that no product of their differences overflows.
///
/// Nor do all products underflow to zero if all points are near each other.
fn scaled<const N: usize, const D: usize>(points: [[f64; D]; N]) -> [[f64; D]; N] {
    const SAFE: core::ops::Range<f64> = 1e-90..1e90;
    let largest = points.as_flattened().iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    if SAFE.contains(&largest) {
        return points;
    }
    // The inverse of the largest number's power of two. That of 2^1023 is subnormal.
    let biased = 2 * 1023 - (largest.to_bits() >> 52);
    let by = f64::from_bits(if biased == 0 { 1 << 51 } else { biased << 52 });
    points.map(|point| point.map(|x| x * by))
}

fn area([ax, ay]: [f64; 2], [bx, by]: [f64; 2], [cx, cy]: [f64; 2]) -> f64 {
    (ax - cx) * (by - cy) - (ay - cy) * (bx - cx)
}

fn volume(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> f64 {
    let [a, b, c] = [a, b, c].map(|p| [p[0] - d[0], p[1] - d[1], p[2] - d[2]]);
    (a[1] * b[2] - a[2] * b[1]) * c[0] + (a[2] * b[0] - a[0] * b[2]) * c[1] + (a[0] * b[1] - a[1] * b[0]) * c[2]
}
