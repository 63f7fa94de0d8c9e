//! The tolerances of space: Figure 5 and Algorithm 6.

use predicament_predicates::Band;

use crate::band;

/// The tolerances for 3D, each as T₋, T and T₊.
///
/// The middle values are computed in the order of Algorithm 6; the outer ones
/// bound exact quantities and are Figure 5's, rounded to nearest. Where the
/// figure says "≈" the value is that of the constraint which defines it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Tolerances3d {
    /// L: no coordinate difference exceeds it.
    pub length: f64,
    /// σ, vertex-vertex: a distance; 6.0, 6.5, 7.0 times ε^¼ L.
    pub sigma: Band,
    /// τ, edge-vertex: a distance; 4.0, 4.5, 5.0 times ε^¼ L.
    pub tau: Band,
    /// δ, face-vertex: a distance; 2.0, 2.25, 2.5 times ε^¼ L.
    pub delta: Band,
    /// γ, edge-edge: a distance; 2.0, 2.25, 2.5 times ε^¼ L.
    pub gamma: Band,
    /// σ̂, vertex-vertex degeneracy rejection: a distance; 5.0, 5.5, 6.0 times ε^¼ L.
    pub sigma_hat: Band,
    /// λ, edge-edge area bound: a squared area; 910, 1215, 1521 times ε L⁴.
    pub lambda: Band,
    /// φ, edge-edge volume bound: a squared area; 150, 470, 760.5 times ε L⁴.
    pub phi: Band,
    /// ν, triangle-vertex area bound: a squared area; 3422.25, 6844.5, 10266.75 times ε L⁴.
    pub nu: Band,
    /// ζ, triangle-vertex volume bound: a squared area; 658, 1317,
    /// 12√3 · 9.75² ≈ 1975.9 times ε L⁴ (ζ₊ = 12√3 (τ₋² − δ₊²)²).
    pub zeta: Band,
    /// μ, triangle-edge volume bound: six times a volume; 16, 24, 32 times ε^¾ L³.
    pub mu: Band,
    /// ξ, triangle-edge volume bound: six times a volume; 28, 56, 48√3 ≈ 83.1
    /// times ε^¾ L³ (ξ₊ = 6√3 γ₋³).
    pub xi: Band,
    /// ρ, tetrahedron-vertex volume bound: six times a volume; as ξ (ρ₊ = 6√3 δ₋³).
    pub rho: Band,
}

impl Tolerances3d {
    /// Algorithm 6: for two meshes, from the largest bounding-box edge of a
    /// primitive of each.
    ///
    /// L = (1 + 5ε)/(1 − 7ε^¼) · (La + Lb) holds two primitives side by side
    /// with σ₊ between them, and its own rounding.
    #[must_use]
    pub fn from_lengths(la: f64, lb: f64) -> Tolerances3d {
        let a = f64::EPSILON.sqrt().sqrt();
        Tolerances3d::from_length((1.0 + 5.0 * f64::EPSILON) / (1.0 - 7.0 * a) * (la + lb))
    }

    /// From L itself, which must bound every coordinate difference.
    #[must_use]
    pub fn from_length(length: f64) -> Tolerances3d {
        let s = f64::EPSILON.sqrt();
        let a = s.sqrt();
        let b = s * a;
        let c = a * length;
        let d = length * length;
        let e = b * length * d;
        let f = f64::EPSILON * (d * d);
        let volume_upper = 48.0 * 3.0_f64.sqrt();
        Tolerances3d {
            length,
            sigma: band([6.0, 6.5, 7.0], c),
            tau: band([4.0, 4.5, 5.0], c),
            delta: band([2.0, 2.25, 2.5], c),
            gamma: band([2.0, 2.25, 2.5], c),
            sigma_hat: band([5.0, 5.5, 6.0], c),
            lambda: band([910.0, 1215.0, 1521.0], f),
            phi: band([150.0, 470.0, 760.5], f),
            nu: band([3422.25, 6844.5, 10266.75], f),
            zeta: band([658.0, 1317.0, 12.0 * 3.0_f64.sqrt() * (9.75 * 9.75)], f),
            mu: band([16.0, 24.0, 32.0], e),
            xi: band([28.0, 56.0, volume_upper], e),
            rho: band([28.0, 56.0, volume_upper], e),
        }
    }
}
