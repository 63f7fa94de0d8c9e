//! The tolerances of space: Figure 5 and Algorithm 6.

use predicament_error_calculus::Root;
use predicament_predicates::{Band, Declined};

use crate::Float;
use crate::band::{self, Unit};
use crate::float::check_precision;

/// The tolerances for 3D, each as T₋, T and T₊, for the arithmetic of `F`.
///
/// The middle values are computed in `F`, in the order of Algorithm 6. The outer values bound exact quantities and are
/// Figure 5's with `F`'s ε, computed in double precision. Where the figure says "≈" the value is that of the constraint
/// which defines it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Tolerances3d<F = f64> {
    /// L: the upper bound of all coordinate differences.
    pub length: F,
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

impl<F: Float> Tolerances3d<F> {
    /// Algorithm 6: the tolerances for two meshes, from the largest bounding-box edge of a primitive of each.
    ///
    /// L = (1 + 5ε)/(1 − 7ε^¼) · (La + Lb) holds two primitives side by side with σ₊ between them, and its own
    /// rounding.
    ///
    /// # Panics
    /// If the machine epsilon of `F` is 10⁻⁵ or more.
    #[must_use]
    pub fn from_lengths(la: F, lb: F) -> Tolerances3d<F> {
        let a = F::EPSILON.sqrt().sqrt();
        let one = F::one();
        let of = F::nearest;
        Tolerances3d::from_length((one + of(5.0) * F::EPSILON) / (one - of(7.0) * a) * (la + lb))
    }

    /// The tolerances for a given L, which must bound every coordinate difference.
    ///
    /// # Panics
    /// If the machine epsilon of `F` is 10⁻⁵ or more.
    #[must_use]
    pub fn from_length(length: F) -> Tolerances3d<F> {
        check_precision::<F>().unwrap_or_else(|declined| panic!("{declined}"));
        let [c, e, f] = Unit::pair(units(F::EPSILON, length), units(F::EPSILON.wide(), length.wide()));
        let volume_upper = 48.0 * 3.0_f64.sqrt();
        Tolerances3d {
            length,
            sigma: c.band([6.0, 6.5, 7.0]),
            tau: c.band([4.0, 4.5, 5.0]),
            delta: c.band([2.0, 2.25, 2.5]),
            gamma: c.band([2.0, 2.25, 2.5]),
            sigma_hat: c.band([5.0, 5.5, 6.0]),
            lambda: f.band([910.0, 1215.0, 1521.0]),
            phi: f.band([150.0, 470.0, 760.5]),
            nu: f.band([3422.25, 6844.5, 10266.75]),
            zeta: f.band([658.0, 1317.0, 12.0 * 3.0_f64.sqrt() * (9.75 * 9.75)]),
            mu: e.band([16.0, 24.0, 32.0]),
            xi: e.band([28.0, 56.0, volume_upper]),
            rho: e.band([28.0, 56.0, volume_upper]),
        }
    }

    /// All tolerances of Figure 5, by the paper's symbols.
    #[must_use]
    pub fn bands(mut self) -> [(&'static str, Band); 12] {
        self.bands_mut().map(|(symbol, band)| (symbol, *band))
    }

    pub(crate) fn bands_mut(&mut self) -> [(&'static str, &mut Band); 12] {
        [
            ("σ", &mut self.sigma),
            ("τ", &mut self.tau),
            ("δ", &mut self.delta),
            ("γ", &mut self.gamma),
            ("σ̂", &mut self.sigma_hat),
            ("λ", &mut self.lambda),
            ("φ", &mut self.phi),
            ("ν", &mut self.nu),
            ("ζ", &mut self.zeta),
            ("μ", &mut self.mu),
            ("ξ", &mut self.xi),
            ("ρ", &mut self.rho),
        ]
    }

    /// Checks that `F` can represent everything that Algorithms 7 to 12 compute.
    ///
    /// The paper assumes "no underflow or overflow"; L = 0 needs no range. The smallest compared value is γ²m² for m² =
    /// λ₋, 3640 ε^(3/2) L⁶; the largest value is d̂² ≤ 36 L⁶. If the first is a normal number, underflow adds to an
    /// error an amount that is negligible beside the gap around it.
    ///
    /// # Errors
    /// [`Declined`] with L.
    pub(crate) fn check_range(&self) -> Result<(), Declined> {
        let cube = self.length * self.length * self.length;
        let gamma = F::nearest(self.gamma.lower);
        let least = gamma * gamma * F::nearest(self.lambda.lower);
        let fits = [self.sigma, self.phi, self.mu].into_iter().all(band::is_sound::<F>)
            && band::is_normal(least)
            && (F::nearest(36.0) * (cube * cube)).wide().is_finite();
        if self.length == F::ZERO || fits {
            return Ok(());
        }
        let (name, length) = (F::NAME, self.length.wide());
        let reason = format!(
            "with L = {length:e} a tolerance of Algorithm 6 or a product of six lengths leaves the range of normal \
             {name}"
        );
        Err(Declined::scene(reason))
    }
}

/// The units c = ε^¼ L, e = ε^¾ L³ and f = ε L⁴, in the order of Algorithm 6.
pub(crate) fn units<N: Root>(epsilon: N, length: N) -> [N; 3] {
    let s = epsilon.clone().sqrt();
    let a = s.clone().sqrt();
    let b = s * a.clone();
    let d = length.clone() * length.clone();
    [a * length.clone(), b * length * d.clone(), epsilon * (d.clone() * d)]
}
