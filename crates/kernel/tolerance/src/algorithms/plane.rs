//! Algorithms 2 to 5: pairs in the plane.

use predicament_error_calculus::vector::minus;

use super::{agree, crossing, differ, fraction, parts, width};
use crate::quantities::{area, distance_squared, edge, line_distance, unit};
use crate::{Float, Tolerances2d};

/// Algorithm 2: true if ‖A − B‖² ≤ σ².
#[inline]
#[must_use]
pub fn vertex_vertex<F: Float>(tolerances: &Tolerances2d<F>, a: &[F; 2], b: &[F; 2]) -> bool {
    let sigma: F = width(tolerances.sigma);
    distance_squared(a, b) <= sigma * sigma
}

/// Algorithm 3, with u = B − A: the vertex is within τ of the edge's line and its foot is on the edge.
///
/// The weight is the fraction of the way from A to B.
#[inline]
#[must_use]
pub fn edge_vertex<F: Float>(tolerances: &Tolerances2d<F>, [a, b]: &[[F; 2]; 2], p: &[F; 2]) -> Option<F> {
    from_edge(tolerances, edge(a, b), &minus(p, a))
}

/// Algorithm 3 from step 7 on, for either û.
#[inline]
pub(super) fn from_edge<F: Float>(tolerances: &Tolerances2d<F>, (u_hat, m): ([F; 2], F), w: &[F; 2]) -> Option<F> {
    if !(m > width(tolerances.sigma_hat)) {
        return None;
    }
    let u = unit(&u_hat, &m);
    if !(line_distance(&u, w) <= width(tolerances.tau)) {
        return None;
    }
    fraction(&u, w, m)
}

/// Algorithm 4: the ends of each edge are on both sides of the other, by areas beyond κ.
///
/// The weights are the fractions of the way from A to B and from P to Q.
#[inline]
#[must_use]
pub fn edge_edge<F: Float>(tolerances: &Tolerances2d<F>, [a, b]: &[[F; 2]; 2], [p, q]: &[[F; 2]; 2]) -> Option<[F; 2]> {
    let kappa = width(tolerances.kappa);
    let of_pq = [area(a, p, b), area(a, q, b)];
    if !differ(of_pq, kappa) {
        return None;
    }
    let of_ab = [area(p, a, q), area(p, b, q)];
    if !differ(of_ab, kappa) {
        return None;
    }
    Some([crossing(of_ab), crossing(of_pq)])
}

/// Algorithm 5: three areas have one sign, beyond κ; the weights are barycentric.
#[inline]
#[must_use]
pub fn triangle_vertex<F: Float>(tolerances: &Tolerances2d<F>, [a, b, c]: &[[F; 2]; 3], p: &[F; 2]) -> Option<[F; 3]> {
    let areas = [area(p, b, c), area(a, p, c), area(a, b, p)];
    agree(areas, width(tolerances.kappa)).then(|| parts(areas))
}
