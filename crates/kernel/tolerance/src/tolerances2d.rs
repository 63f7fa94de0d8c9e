//! The tolerances of the plane: Figure 1 and Algorithm 1.

use predicament_error_calculus::Root;
use predicament_predicates::{Band, Declined};

use crate::Float;
use crate::band::{self, Unit};
use crate::float::check_precision;

/// The tolerances for 2D, each as T₋, T and T₊, for the arithmetic of `F`.
///
/// The middle values are computed in `F`, in the order of Algorithm 1. The outer values bound exact quantities and are
/// Figure 1's with `F`'s ε, computed in double precision. The gap between them is 10⁶ times larger than that rounding
/// for `f32` and 10¹⁵ times for `f64`, for κ as for the lengths.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Tolerances2d<F = f64> {
    /// L: the upper bound of all coordinate differences.
    pub length: F,
    /// σ, vertex-vertex: a distance; 6.0, 6.5, 7.0 times √ε L.
    pub sigma: Band,
    /// τ, edge-vertex: a distance; 4.0, 4.5, 5.0 times √ε L.
    pub tau: Band,
    /// σ̂, vertex-vertex degeneracy rejection: a distance; 5.0, 5.5, 6.0 times √ε L.
    pub sigma_hat: Band,
    /// κ, edge-edge area bound: twice an area; 10, 21, 32 times ε L².
    pub kappa: Band,
}

impl<F: Float> Tolerances2d<F> {
    /// Algorithm 1: the tolerances for two meshes, from the largest bounding-box edge of a primitive of each.
    ///
    /// L = (1 + 5ε)/(1 − 7√ε) · (La + Lb) holds two primitives side by side with σ₊ between them, and its own rounding.
    /// (The text of 4.1 has 8√ε in the denominator; σ₊ = 7√ε L needs the 7 of the algorithm.)
    ///
    /// # Panics
    /// If the machine epsilon of `F` is 10⁻⁵ or more.
    #[must_use]
    pub fn from_lengths(la: F, lb: F) -> Tolerances2d<F> {
        let s = F::EPSILON.sqrt();
        let one = F::one();
        let of = F::nearest;
        Tolerances2d::from_length((one + of(5.0) * F::EPSILON) / (one - of(7.0) * s) * (la + lb))
    }

    /// The tolerances for a given L, which must bound every coordinate difference.
    ///
    /// # Panics
    /// If the machine epsilon of `F` is 10⁻⁵ or more.
    #[must_use]
    pub fn from_length(length: F) -> Tolerances2d<F> {
        check_precision::<F>().unwrap_or_else(|declined| panic!("{declined}"));
        let epsilon = F::EPSILON.wide();
        let [t, square] = Unit::pair(units(F::EPSILON, length), units(epsilon, length.wide()));
        Tolerances2d {
            length,
            sigma: t.band([6.0, 6.5, 7.0]),
            tau: t.band([4.0, 4.5, 5.0]),
            sigma_hat: t.band([5.0, 5.5, 6.0]),
            kappa: square.band([10.0, 21.0, 32.0].map(|c| c * epsilon)),
        }
    }

    /// All tolerances of Figure 1, by the paper's symbols.
    #[must_use]
    pub fn bands(mut self) -> [(&'static str, Band); 4] {
        self.bands_mut().map(|(symbol, band)| (symbol, *band))
    }

    pub(crate) fn bands_mut(&mut self) -> [(&'static str, &mut Band); 4] {
        [("σ", &mut self.sigma), ("τ", &mut self.tau), ("σ̂", &mut self.sigma_hat), ("κ", &mut self.kappa)]
    }

    /// Checks that `F` can represent everything that Algorithms 2 to 5 compute.
    ///
    /// The paper assumes "no underflow or overflow"; L = 0 needs no range. σ² and κ stand for the compared values: if
    /// both are normal numbers, underflow adds to an error an amount that is negligible beside the gaps around them.
    ///
    /// # Errors
    /// [`Declined`] with L.
    pub(crate) fn check_range(&self) -> Result<(), Declined> {
        let square = self.length * self.length;
        // |a_A − a_B| ≤ 4 L²
        let fits = band::is_sound::<F>(self.sigma)
            && band::is_sound::<F>(self.kappa)
            && (F::nearest(4.0) * square).wide().is_finite();
        if self.length == F::ZERO || fits {
            return Ok(());
        }
        let (name, length) = (F::NAME, self.length.wide());
        let reason =
            format!("with L = {length:e} the tolerance κ = 21 ε L² or an area leaves the range of normal {name}");
        Err(Declined::scene(reason))
    }
}

/// The units √ε L and L², in the order of Algorithm 1.
pub(crate) fn units<N: Root>(epsilon: N, length: N) -> [N; 2] {
    [epsilon.sqrt() * length.clone(), length.clone() * length]
}
