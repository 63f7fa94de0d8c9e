//! Bands from their printed coefficients.

use predicament_predicates::Band;

use crate::Float;

/// What the coefficients of a tolerance are multiples of: as the algorithm
/// computes it, and in double precision for the bounds that are never computed.
#[derive(Clone, Copy)]
pub(crate) struct Unit<F> {
    pub(crate) here: F,
    pub(crate) wide: f64,
}

impl<F: Float> Unit<F> {
    pub(crate) fn pair<const N: usize>(here: [F; N], wide: [f64; N]) -> [Unit<F>; N] {
        std::array::from_fn(|i| Unit { here: here[i], wide: wide[i] })
    }

    /// T₋, T and T₊. The printed coefficients of T are numbers of every format.
    pub(crate) fn band(self, [lower, width, upper]: [f64; 3]) -> Band {
        let width = F::nearest(width) * self.here;
        Band { lower: lower * self.wide, width: width.wide(), upper: upper * self.wide }
    }
}

/// Whether a band is what its formula says in the format: neither infinite nor
/// NaN, and nothing of it lost to underflow.
pub(crate) fn is_sound<F: Float>(band: Band) -> bool {
    [band.lower, band.width, band.upper].into_iter().all(|x| is_normal(F::nearest(x)))
}

/// For what is positive: finite, with a full significand.
pub(crate) fn is_normal<F: Float>(x: F) -> bool {
    x >= F::MIN_POSITIVE && x.wide().is_finite()
}
