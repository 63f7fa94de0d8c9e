//! The determinants as polynomials: degree, growth, filter constant.
//!
//! `growth` bounds intermediates of filters *and* of expansions. With all
//! differences less than M, the sum of the magnitudes of all terms is at most
//! 2M² for orient2d, 6M³ for orient3d, 3·2·2 M⁴ = 12M⁴ for incircle and
//! 4·6·3 M⁵ = 72M⁵ for insphere. Expansions hold partial sums of the same
//! terms, or, at the last stage of insphere, of the 5 × 5 determinant of the
//! coordinates themselves: 120 products of three coordinates less than M/2
//! and a lift less than 3(M/2)², less than 12M⁵ in all. Corrections by tails
//! multiply a factor by u. What expansions overshoot by is a few roundings.
//! Twice the first numbers covers it all.

use predicament_arithmetic::{Form, Regime, bound};

/// A determinant: what a plan needs to know, and the constant of its filter.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Determinant {
    /// Degree and growth.
    pub form: Form,
    /// The constant of the semi-static filter, to be multiplied with the permanent.
    pub bound: f64,
}

impl Determinant {
    /// The bound to run the filter with: zero where plain floating point makes
    /// no error, NaN (with which the filter never answers) where nothing is proved.
    #[inline]
    #[must_use]
    pub const fn bound_in(self, regime: Regime) -> f64 {
        match regime {
            Regime::Exact => 0.0,
            Regime::Safe => self.bound,
            Regime::Unproved => f64::NAN,
        }
    }
}

/// The turn of three points.
pub const ORIENT2D: Determinant = Determinant { form: Form { degree: 2, growth: 2 }, bound: bound::ORIENT2D };
/// The side of a point on a plane.
pub const ORIENT3D: Determinant = Determinant { form: Form { degree: 3, growth: 4 }, bound: bound::ORIENT3D };
/// A point in a circle.
pub const INCIRCLE: Determinant = Determinant { form: Form { degree: 4, growth: 5 }, bound: bound::INCIRCLE };
/// A point in a sphere.
pub const INSPHERE: Determinant = Determinant { form: Form { degree: 5, growth: 8 }, bound: bound::INSPHERE };
