//! The determinants as polynomials: degree, growth, filter constant, bits.
//!
//! With all differences less than M, the sum of the magnitudes of all terms is
//! at most 2M² for orient2d, 6M³ for orient3d, 3·2·2 M⁴ = 12M⁴ for incircle
//! and 4·6·3 M⁵ = 72M⁵ for insphere: `growth` is the next logarithm to base
//! two. The bits for integers are counted in [`integer_determinants`].

use predicament_arithmetic::{Form, Parts, bound};

use crate::integer_determinants;

/// A determinant: what a plan needs to know, and the constant of its filter.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Determinant {
    /// Degree, growth and bits.
    pub form: Form,
    /// The constant of the semi-static filter, to be multiplied with the permanent.
    pub bound: f64,
}

impl Determinant {
    /// The limbs that hold any determinant of differences of this many bits.
    #[must_use]
    pub const fn limbs(&self, bits: i32) -> usize {
        limbs(self.form.degree * bits + self.form.growth)
    }

    /// The limbs that hold one which a filter has left open.
    ///
    /// The filter has found |d| < B·p, and d errs by no more than a determinant
    /// must to have the wrong sign: so |D| < 2.01·B·2^growth·M^degree, where what is
    /// of second order in u is paid for by the hundredth. Both filters are meant:
    /// B·p, for M larger than the differences of the query, and the static bound,
    /// for M larger than those of the scene.
    #[inline(always)] // most of it is known when it is compiled
    #[must_use]
    pub const fn limbs_left_open(&self, bits: i32) -> usize {
        let share = 2.01 * self.bound;
        let exponent = Parts::of(share).expect("a bound is finite").highest().expect("and positive");
        limbs(self.form.degree * bits + self.form.growth + exponent)
    }
}

/// The limbs of integers less than 2^`bits`, and their signs.
#[inline(always)]
const fn limbs(bits: i32) -> usize {
    if bits < 0 { 1 } else { (bits.cast_unsigned() + 1).div_ceil(64) as usize }
}

const fn determinant(degree: i32, growth: i32, bound: f64) -> Determinant {
    Determinant { form: Form { degree, growth, integer_bits: integer_determinants::BITS }, bound }
}

/// The turn of three points.
pub const ORIENT2D: Determinant = determinant(2, 1, bound::ORIENT2D);
/// The side of a point on a plane.
pub const ORIENT3D: Determinant = determinant(3, 3, bound::ORIENT3D);
/// A point in a circle.
pub const INCIRCLE: Determinant = determinant(4, 4, bound::INCIRCLE);
/// A point in a sphere.
pub const INSPHERE: Determinant = determinant(5, 7, bound::INSPHERE);
