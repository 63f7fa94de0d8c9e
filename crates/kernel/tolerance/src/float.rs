//! The binary floating-point formats of the scheme.

use std::fmt::Debug;

use predicament_error_calculus::Root;
use predicament_predicates::Declined;

/// A binary floating-point format that rounds to nearest.
///
/// ε is the *machine* epsilon, the distance from 1 to the next number. The paper proves its tolerances for ε < 10⁻⁵;
/// every constructor of tolerances refuses other formats.
pub trait Float: Root + Copy + PartialOrd + Debug + Send + Sync + 'static {
    /// The type's name.
    const NAME: &'static str;

    /// The machine epsilon ε: 2⁻⁵² for `f64`, 2⁻²³ for `f32`.
    const EPSILON: Self;

    /// The smallest number with a full significand.
    const MIN_POSITIVE: Self;

    /// The number zero.
    const ZERO: Self;

    /// True if some doubles are not numbers of this format, so that a shift of a scene can help.
    const IS_NARROW: bool = true;

    /// The same value as a double, which holds it exactly.
    fn wide(self) -> f64;

    /// The number of this format that is nearest to the double.
    fn nearest(x: f64) -> Self;

    /// The smallest number of this format that is not below the double.
    fn above(x: f64) -> Self;
}

impl Float for f64 {
    const NAME: &'static str = "f64";
    const EPSILON: f64 = f64::EPSILON;
    const MIN_POSITIVE: f64 = f64::MIN_POSITIVE;
    const ZERO: f64 = 0.0;
    const IS_NARROW: bool = false;

    #[inline]
    fn wide(self) -> f64 {
        self
    }

    #[inline]
    fn nearest(x: f64) -> f64 {
        x
    }

    #[inline]
    fn above(x: f64) -> f64 {
        x
    }
}

impl Float for f32 {
    const NAME: &'static str = "f32";
    const EPSILON: f32 = f32::EPSILON;
    const MIN_POSITIVE: f32 = f32::MIN_POSITIVE;
    const ZERO: f32 = 0.0;

    #[inline]
    fn wide(self) -> f64 {
        self.into()
    }

    #[inline]
    #[allow(clippy::cast_possible_truncation)] // rounds to nearest
    fn nearest(x: f64) -> f32 {
        x as f32
    }

    #[inline]
    fn above(x: f64) -> f32 {
        let nearest = f32::nearest(x);
        if nearest.wide() < x { nearest.next_up() } else { nearest }
    }
}

/// The upper limit of ε, 10⁻⁵: section 2 of the paper.
const EPSILON_LIMIT: f64 = 1e-5;

/// Checks that the format is fine enough for the proofs.
///
/// # Errors
/// [`Declined`] with the epsilon and the limit.
pub(crate) fn check_precision<F: Float>() -> Result<(), Declined> {
    let epsilon = F::EPSILON.wide();
    if epsilon < EPSILON_LIMIT {
        return Ok(());
    }
    let name = F::NAME;
    Err(Declined::scene(format!(
        "the tolerances are proved for machine epsilons below {EPSILON_LIMIT:e}; that of {name} is {epsilon:e}"
    )))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn above_is_the_smallest_that_is_not_below() {
        for x in [0.0, 1.0, 0.1, -0.1, 1.0 + 1e-12, 1.0 - 1e-12, 1e-60, -1e-60, 3e38, 4e38, 5e-324] {
            let above = f32::above(x);
            assert!(above.wide() >= x, "{x:e}");
            assert!(above.next_down().wide() < x, "{x:e}: {above:e} is not the smallest");
        }
        assert_eq!(f32::above(4e38), f32::INFINITY);
        assert_eq!(f64::above(0.1), 0.1);
    }
}
