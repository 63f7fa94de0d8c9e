//! The quantities of sections 4 and 5, each one function over any number type.
//!
//! In floating point it is the value that the algorithms compute, on rationals the exact value, and on the numbers of
//! the error calculus the bound.
//!
//! Names are the paper's. If the paper leaves the order of evaluation open, the order here is that of its pseudocode.
//! Unit vectors are û · (1/m): one division, in the order of the published bounds.

use predicament_error_calculus::vector::{cross, dot, minus, norm, norm_squared, perp, scaled};
use predicament_error_calculus::{Ring, Root};

/// The squared distance ‖A − B‖², (3) and (10).
#[inline]
pub fn distance_squared<N: Ring, const D: usize>(a: &[N; D], b: &[N; D]) -> N {
    norm_squared(&minus(a, b))
}

/// The edge û = B − A and its length m.
///
/// The paper prints û = A − B, which gives the weight â/m the wrong sign.
#[inline]
pub fn edge<N: Root, const D: usize>(a: &[N; D], b: &[N; D]) -> ([N; D], N) {
    let u_hat = minus(b, a);
    let m = norm(&u_hat);
    (u_hat, m)
}

/// The unit vector u = û · (1/m).
#[inline]
pub fn unit<N: Root, const D: usize>(u_hat: &[N; D], m: &N) -> [N; D] {
    scaled(u_hat, &(N::one() / m.clone()))
}

/// The distance from the line in the plane, d = |u × w|, (5).
#[inline]
pub fn line_distance<N: Ring>(u: &[N; 2], w: &[N; 2]) -> N {
    perp(u, w).abs()
}

/// The squared distance from the line in space, d² = ‖u × w‖², (12).
#[inline]
pub fn line_distance_squared<N: Ring>(u: &[N; 3], w: &[N; 3]) -> N {
    norm_squared(&cross(u, w))
}

/// The signed distances of the foot to A and B: â = u · w and ā = m − â, (5) and (12).
#[inline]
pub fn along<N: Ring, const D: usize>(u: &[N; D], w: &[N; D], m: &N) -> [N; 2] {
    let a_hat = dot(u, w);
    let a_bar = m.clone() - a_hat.clone();
    [a_hat, a_bar]
}

/// Twice the signed area of a triangle, (6) and (8): (Q − P) × (R − P), counterclockwise positive.
#[inline(always)]
pub fn area<N: Ring>(p: &[N; 2], q: &[N; 2], r: &[N; 2]) -> N {
    perp(&minus(q, p), &minus(r, p))
}

/// Six times the signed volume of a tetrahedron, (17) to (21): ((A − D) × (B − D)) · (C − D).
#[inline(always)]
pub fn volume<N: Ring>(a: &[N; 3], b: &[N; 3], c: &[N; 3], d: &[N; 3]) -> N {
    dot(&cross(&minus(a, d), &minus(b, d)), &minus(c, d))
}

/// The normal vector r = u × v and its squared length m², (13) and (15).
#[inline]
pub fn normal<N: Ring>(u: &[N; 3], v: &[N; 3]) -> ([N; 3], N) {
    let r = cross(u, v);
    let m_squared = norm_squared(&r);
    (r, m_squared)
}

/// The height d̂ = r · w, (14) and (16): m times the distance.
#[inline]
pub fn height<N: Ring>(r: &[N; 3], w: &[N; 3]) -> N {
    dot(r, w)
}

/// The weights â, b̂, ā and b̂'s complement b̄ of two edges, (14), all times m².
#[inline]
pub fn edge_edge_weights<N: Ring>(r: &[N; 3], w: &[N; 3], u: &[N; 3], v: &[N; 3], m_squared: &N) -> [N; 4] {
    let n = cross(r, w);
    let a_hat = dot(&n, v);
    let b_hat = dot(&n, u);
    let a_bar = m_squared.clone() - a_hat.clone();
    let b_bar = m_squared.clone() - b_hat.clone();
    [a_hat, b_hat, a_bar, b_bar]
}

/// The weights â, b̂ and ĉ of a triangle and a vertex, (16), all times m².
#[inline]
pub fn triangle_vertex_weights<N: Ring>(r: &[N; 3], w: &[N; 3], u: &[N; 3], v: &[N; 3], m_squared: &N) -> [N; 3] {
    let n = cross(r, w);
    let c_hat = -dot(&n, u);
    let b_hat = dot(&n, v);
    let a_hat = m_squared.clone() - b_hat.clone() - c_hat.clone();
    [a_hat, b_hat, c_hat]
}
