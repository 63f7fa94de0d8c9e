//! The tolerances of the plane: Figure 1 and Algorithm 1.

use predicament_predicates::Band;

use crate::band;

/// The tolerances for 2D, each as T₋, T and T₊.
///
/// The middle values are computed in the order of Algorithm 1; the outer ones
/// bound exact quantities and are Figure 1's, rounded to nearest. The room
/// between them is some 10¹⁵ times larger than that rounding, for κ as for the
/// lengths.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Tolerances2d {
    /// L: no coordinate difference exceeds it.
    pub length: f64,
    /// σ, vertex-vertex: a distance; 6.0, 6.5, 7.0 times √ε L.
    pub sigma: Band,
    /// τ, edge-vertex: a distance; 4.0, 4.5, 5.0 times √ε L.
    pub tau: Band,
    /// σ̂, vertex-vertex degeneracy rejection: a distance; 5.0, 5.5, 6.0 times √ε L.
    pub sigma_hat: Band,
    /// κ, edge-edge area bound: twice an area; 10, 21, 32 times ε L².
    pub kappa: Band,
}

impl Tolerances2d {
    /// Algorithm 1: for two meshes, from the largest bounding-box edge of a
    /// primitive of each.
    ///
    /// L = (1 + 5ε)/(1 − 7√ε) · (La + Lb) holds two primitives side by side
    /// with σ₊ between them, and its own rounding. (The text of 4.1 has 8√ε
    /// in the denominator; σ₊ = 7√ε L needs the 7 of the algorithm.)
    #[must_use]
    pub fn from_lengths(la: f64, lb: f64) -> Tolerances2d {
        let s = f64::EPSILON.sqrt();
        Tolerances2d::from_length((1.0 + 5.0 * f64::EPSILON) / (1.0 - 7.0 * s) * (la + lb))
    }

    /// From L itself, which must bound every coordinate difference.
    #[must_use]
    pub fn from_length(length: f64) -> Tolerances2d {
        let t = f64::EPSILON.sqrt() * length;
        let square = length * length;
        Tolerances2d {
            length,
            sigma: band([6.0, 6.5, 7.0], t),
            tau: band([4.0, 4.5, 5.0], t),
            sigma_hat: band([5.0, 5.5, 6.0], t),
            kappa: band([10.0, 21.0, 32.0].map(|c| c * f64::EPSILON), square),
        }
    }
}
