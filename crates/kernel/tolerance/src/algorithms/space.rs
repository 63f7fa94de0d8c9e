//! Algorithms 7 to 12: pairs in space.

use predicament_error_calculus::vector::minus;

use super::{agree, crossing, differ, fraction, parts, width};
use crate::quantities::{
    distance_squared, edge, edge_edge_weights, height, line_distance_squared, normal, triangle_vertex_weights, unit,
    volume,
};
use crate::{Float, Tolerances3d};

/// Algorithm 7: true if ‖A − B‖² ≤ σ².
#[inline]
#[must_use]
pub fn vertex_vertex<F: Float>(tolerances: &Tolerances3d<F>, a: &[F; 3], b: &[F; 3]) -> bool {
    let sigma: F = width(tolerances.sigma);
    distance_squared(a, b) <= sigma * sigma
}

/// Algorithm 8, with u = B − A: the vertex is within τ of the edge's line and its foot is on the edge.
///
/// The weight is the fraction of the way from A to B.
#[inline]
#[must_use]
pub fn edge_vertex<F: Float>(tolerances: &Tolerances3d<F>, [a, b]: &[[F; 3]; 2], p: &[F; 3]) -> Option<F> {
    from_edge(tolerances, edge(a, b), &minus(p, a))
}

/// Algorithm 8 from step 7 on, for either û.
#[inline]
pub(super) fn from_edge<F: Float>(tolerances: &Tolerances3d<F>, (u_hat, m): ([F; 3], F), w: &[F; 3]) -> Option<F> {
    if !(m > width(tolerances.sigma_hat)) {
        return None;
    }
    let u = unit(&u_hat, &m);
    let tau: F = width(tolerances.tau);
    if !(line_distance_squared(&u, w) <= tau * tau) {
        return None;
    }
    fraction(&u, w, m)
}

/// Algorithm 9: the lines are within γ, and their closest points are on both edges.
///
/// The edges must not be too parallel. The weights are the fractions of the way from A to B and from P to Q.
#[inline]
#[must_use]
pub fn edge_edge<F: Float>(tolerances: &Tolerances3d<F>, [a, b]: &[[F; 3]; 2], [p, q]: &[[F; 3]; 2]) -> Option<[F; 2]> {
    let (u, v) = (minus(b, a), minus(q, p));
    let (r, m_squared) = normal(&u, &v);
    if !(m_squared > width(tolerances.lambda)) {
        return None;
    }
    let w = minus(p, a);
    let gamma: F = width(tolerances.gamma);
    if !(height(&r, &w).square() <= gamma * gamma * m_squared) {
        return None;
    }
    let weights = edge_edge_weights(&r, &w, &u, &v, &m_squared);
    let phi: F = width(tolerances.phi);
    let [a_hat, b_hat, ..] = weights;
    weights.into_iter().all(|weight| weight > phi).then(|| [a_hat / m_squared, b_hat / m_squared])
}

/// Algorithm 10: the vertex is within δ of the triangle's plane and its foot is in the triangle.
///
/// The triangle must not be too thin. The weights are barycentric. Near ε = 10⁻⁵ ν excludes every triangle within L.
#[inline]
#[must_use]
pub fn triangle_vertex<F: Float>(tolerances: &Tolerances3d<F>, [a, b, c]: &[[F; 3]; 3], p: &[F; 3]) -> Option<[F; 3]> {
    let (u, v) = (minus(b, a), minus(c, a));
    let (r, m_squared) = normal(&u, &v);
    if !(m_squared > width(tolerances.nu)) {
        return None;
    }
    let w = minus(p, a);
    let delta: F = width(tolerances.delta);
    if !(height(&r, &w).square() <= delta * delta * m_squared) {
        return None;
    }
    let weights = triangle_vertex_weights(&r, &w, &u, &v, &m_squared);
    let zeta: F = width(tolerances.zeta);
    weights.into_iter().all(|weight| weight > zeta).then(|| weights.map(|weight| weight / m_squared))
}

/// Algorithm 11: the edge pierces the triangle.
///
/// The edge's line passes the triangle's edges on one side, by volumes beyond μ, and its ends are on both sides of the
/// plane, by volumes beyond ξ. The weights are barycentric, and the fraction of the way from P to Q.
#[inline]
#[must_use]
pub fn triangle_edge<F: Float>(
    tolerances: &Tolerances3d<F>,
    [a, b, c]: &[[F; 3]; 3],
    [p, q]: &[[F; 3]; 2],
) -> Option<([F; 3], F)> {
    let around = [volume(b, c, p, q), volume(c, a, p, q), volume(a, b, p, q)];
    if !agree(around, width(tolerances.mu)) {
        return None;
    }
    let ends = [volume(a, b, c, p), volume(a, b, c, q)];
    differ(ends, width(tolerances.xi)).then(|| (parts(around), crossing(ends)))
}

/// Algorithm 12: four volumes have one sign, beyond ρ; the weights are barycentric.
#[inline]
#[must_use]
pub fn tetrahedron_vertex<F: Float>(
    tolerances: &Tolerances3d<F>,
    [a, b, c, d]: &[[F; 3]; 4],
    p: &[F; 3],
) -> Option<[F; 4]> {
    let volumes = [volume(b, c, d, p), volume(p, c, d, a), volume(b, p, d, a), volume(b, c, p, a)];
    agree(volumes, width(tolerances.rho)).then(|| parts(volumes))
}
