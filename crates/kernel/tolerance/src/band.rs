//! Bands from their printed coefficients.

use predicament_predicates::Band;

use crate::Float;

/// The unit that the coefficients of a tolerance multiply.
///
/// It is stored as the algorithm computes it, and in double precision for the bounds that the algorithm never computes.
#[derive(Clone, Copy)]
pub(crate) struct Unit<F> {
    pub(crate) here: F,
    pub(crate) wide: f64,
}

impl<F: Float> Unit<F> {
    pub(crate) fn pair<const N: usize>(here: [F; N], wide: [f64; N]) -> [Unit<F>; N] {
        std::array::from_fn(|i| Unit { here: here[i], wide: wide[i] })
    }

    /// The band T₋, T and T₊; every format can represent the printed coefficients of T.
    pub(crate) fn band(self, [lower, width, upper]: [f64; 3]) -> Band {
        let width = F::nearest(width) * self.here;
        Band { lower: lower * self.wide, width: width.wide(), upper: upper * self.wide }
    }
}

/// Returns true if a band has the value of its formula in the format.
///
/// It must be neither infinite nor NaN, and not have lost precision to underflow.
pub(crate) fn is_sound<F: Float>(band: Band) -> bool {
    [band.lower, band.width, band.upper].into_iter().all(|x| is_normal(F::nearest(x)))
}

/// Returns true for a positive number that is finite and has a full significand.
pub(crate) fn is_normal<F: Float>(x: F) -> bool {
    x >= F::MIN_POSITIVE && x.wide().is_finite()
}
