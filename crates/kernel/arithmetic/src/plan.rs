//! The consequences of a scene's exponents for arithmetic on it.
//!
//! Floating-point filters are right if nothing overflows and nothing underflows. Plain floating point is exact if
//! nothing has more than 53 bits. Integers of a fixed size are exact if everything fits. All of this is known in
//! advance, from two exponents and the degree of the computation.
//!
//! # The proof
//! Let every coordinate be a multiple of 2^l, and every difference of two coordinates of the same axis less than M =
//! 2^s in magnitude. Let an algorithm take differences first and then only sums, differences and products, so that each
//! of its intermediates is homogeneous of some degree 1 ≤ j ≤ k in the differences.
//!
//! **Granularity.** Sums and differences of multiples of 2^g are multiples of 2^g; products of multiples of 2^g and
//! 2^g′ are multiples of 2^(g+g′). A double nearest to a multiple of 2^g is a multiple of 2^g itself: either the value
//! is representable, or the doubles around it lie on a coarser grid. By induction each intermediate of degree j,
//! *rounded or not*, is a multiple of 2^(j·l). The subnormal grid is 2^-1074, so if j·l ≥ -1074 for all j, tiny results
//! are exact.
//!
//! **Bounds.** Filters multiply a sum of degree k by a constant of at least u = 2^-53. For this product to be rounded
//! as usual it must not be subnormal, unless zero: **k·l ≥ -969**, which implies the condition above. (For l > 0
//! nothing can be lost.)
//!
//! **Magnitude.** If every intermediate of degree j is less than 2^growth · M^j, then none overflows if **max(k·s, 0) +
//! growth ≤ 1023** (the step from 2^1023 to the largest double covers the roundings of sums, a relative u each).
//!
//! **Exactness.** An intermediate of degree j is a multiple of 2^(j·l) and less than 2^(j·s + growth). If **k·(s − l) +
//! growth ≤ 53** it has 53 bits at most, for each j (since s > l), and plain floating point makes no error. For k = 1
//! this says that differences are exact if s − l ≤ 53.
//!
//! **Integers.** Differences over 2^l are integers of s − l bits. The modules of the determinants count how many limbs
//! the other values need; a [`Form`] carries the result.

use crate::{Parts, power_of_two};
use alloc::vec::Vec;

/// The lowest exponent of a nonzero sum whose product with u is still normal.
const LOWEST: i32 = -1022 + 53;
/// The exponent that every intermediate must stay below.
const HIGHEST: i32 = 1023;
/// The number of significand bits of a double.
const PRECISION: i32 = 53;

/// The exponents of the lowest and the highest bit of some nonzero doubles.
///
/// Every value x of the list is an integer multiple of 2^`lowest`, and |x| < 2^`highest`. Both are tight: some value
/// has a bit set at `lowest`, and some |x| ≥ 2^(`highest` − 1). So `lowest` < `highest`, and for finite values both lie
/// within −1074 ..= 1024.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct ExponentRange {
    /// The exponent of the lowest bit that is set in any value.
    pub lowest: i32,
    /// The least e with |x| < 2^e for every value x.
    pub highest: i32,
}

impl ExponentRange {
    /// The range of all nonzero values; `None` if all are zero.
    ///
    /// It is for finite values. Infinities and NaN count as an unspecified number of 2^1024 or more, for which no
    /// [`Plan`](crate::Plan) proves anything.
    #[must_use]
    pub fn of<'a>(values: impl IntoIterator<Item = &'a f64>) -> Option<ExponentRange> {
        values.into_iter().filter_map(|&x| ExponentRange::of_one(x)).reduce(ExponentRange::and)
    }

    /// The smallest range that contains both.
    #[must_use]
    pub fn and(self, other: ExponentRange) -> ExponentRange {
        ExponentRange { lowest: self.lowest.min(other.lowest), highest: self.highest.max(other.highest) }
    }

    #[inline]
    fn of_one(x: f64) -> Option<ExponentRange> {
        let parts = Parts::of_any(x);
        Some(ExponentRange { lowest: parts.lowest()?, highest: parts.highest()? })
    }
}

/// A polynomial in differences of coordinates, described by degree and growth.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Form {
    /// The degree: the number of differences in each term.
    pub degree: i32,
    /// The growth of sums.
    ///
    /// An intermediate of degree j is less than 2^`growth` · M^j, if all differences are less than M.
    pub growth: i32,
    /// The largest bit lengths of a difference for fixed-size integers, with differences of one limb and of two.
    pub integer_bits: [i32; 2],
}

/// The cheapest arithmetic that makes no error.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Arithmetic {
    /// Doubles, if every intermediate is representable.
    Double,
    /// Integers of a fixed size, with differences of one limb.
    Integer,
    /// Integers of a fixed size, with differences of two limbs.
    WideInteger,
    /// Exact dyadic numbers: limbs times a power of two.
    Dyadic,
}

impl Arithmetic {
    /// All arithmetics, cheapest first.
    pub const ALL: [Arithmetic; 4] =
        [Arithmetic::Double, Arithmetic::Integer, Arithmetic::WideInteger, Arithmetic::Dyadic];

    /// The arithmetic's name in lists.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Arithmetic::Double => "double",
            Arithmetic::Integer => "integer",
            Arithmetic::WideInteger => "wide integer",
            Arithmetic::Dyadic => "dyadic",
        }
    }
}

/// The coordinate range of some points along one axis.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Span {
    /// The exponents of the coordinates; `None` if all are zero.
    pub range: Option<ExponentRange>,
    /// The least coordinate.
    pub min: f64,
    /// The largest coordinate.
    pub max: f64,
}

impl Span {
    /// The least double that is not less than any difference of two coordinates.
    ///
    /// It is infinite if no double is large enough.
    #[must_use]
    pub fn extent(&self) -> f64 {
        // (Without points, the maximum is less than the minimum.)
        if self.max < self.min { 0.0 } else { difference_up(self.max, self.min) }
    }
}

/// The exact error of a − b rounded to `difference` (Knuth).
#[inline(always)]
#[must_use]
pub fn exact_tail(a: f64, b: f64, difference: f64) -> f64 {
    let virtual_b = a - difference;
    let virtual_a = difference + virtual_b;
    (a - virtual_a) + (virtual_b - b)
}

/// The consequences of some points' exponents for arithmetic on them.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Plan<const D: usize> {
    axes: [Span; D],
    /// Every coordinate is a multiple of 2^`lowest`, every difference less than 2^`span`.
    lowest: i32,
    span: i32,
}

impl<const D: usize> Plan<D> {
    /// The plan for these points.
    #[must_use]
    pub fn of(points: &[[f64; D]]) -> Plan<D> {
        let axes = core::array::from_fn(|axis| {
            let column = || points.iter().map(|point| &point[axis]);
            let min = column().fold(f64::INFINITY, |min, &x| if x < min { x } else { min });
            let max = column().fold(f64::NEG_INFINITY, |max, &x| if x > max { x } else { max });
            Span { range: ExponentRange::of(column()), min, max }
        });
        Plan::of_axes(axes)
    }

    fn of_axes(axes: [Span; D]) -> Plan<D> {
        let lowest = axes.iter().filter_map(|axis| axis.range).map(|range| range.lowest).min().unwrap_or(0);
        let extents: [f64; D] = axes.map(|axis| axis.extent());
        let span = ExponentRange::of(&extents).map(|range| range.highest);
        // Without any nonzero difference all determinants are zero, in any arithmetic.
        Plan { axes, lowest, span: span.unwrap_or(lowest + 1) }
    }

    /// The plan for the same points, projected to some of their axes.
    ///
    /// # Panics
    /// If there is no such axis.
    #[must_use]
    pub fn project<const E: usize>(&self, axes: [usize; E]) -> Plan<E> {
        Plan::of_axes(axes.map(|axis| self.axes[axis]))
    }

    /// The coordinate range of each axis.
    #[must_use]
    pub fn axes(&self) -> &[Span; D] {
        &self.axes
    }

    /// The exponent of the lowest bit: every coordinate is a multiple of 2 to this power.
    #[must_use]
    pub fn lowest(&self) -> i32 {
        self.lowest
    }

    /// The bit length of the largest difference, in units of the lowest bit.
    #[must_use]
    pub fn bits(&self) -> i32 {
        self.span - self.lowest
    }

    /// Returns true if all differences are representable doubles.
    #[must_use]
    pub fn has_exact_differences(&self) -> bool {
        self.bits() <= PRECISION
    }

    /// Returns true if no difference overflows.
    #[must_use]
    pub fn has_finite_differences(&self) -> bool {
        self.span <= HIGHEST
    }

    /// Returns true if floating-point filters are valid: nothing overflows or underflows.
    #[must_use]
    pub fn allows_filters(&self, form: Form) -> bool {
        form.degree * self.lowest >= LOWEST && (form.degree * self.span).max(0) + form.growth <= HIGHEST
    }

    /// The cheapest arithmetic that makes no error in this form.
    #[must_use]
    pub fn arithmetic(&self, form: Form) -> Arithmetic {
        let [one, two] = form.integer_bits;
        if self.allows_filters(form) && form.degree * self.bits() + form.growth <= PRECISION {
            Arithmetic::Double
        } else if !self.has_finite_differences() {
            Arithmetic::Dyadic
        } else if self.bits() <= one {
            Arithmetic::Integer
        } else if self.bits() <= two {
            Arithmetic::WideInteger
        } else {
            Arithmetic::Dyadic
        }
    }

    /// The power of two that scales all coordinates to integers less than 2^63 in magnitude.
    ///
    /// `None` if there is no such power that is a normal double.
    #[must_use]
    pub fn scale(&self) -> Option<f64> {
        let fits = |axis: &Span| axis.range.is_none_or(|range| range.highest - self.lowest <= 63);
        (self.axes.iter().all(fits) && (-1022..=1022).contains(&self.lowest)).then(|| power_of_two(-self.lowest))
    }

    /// All points in units of their lowest bit, modulo 2^64.
    ///
    /// Differences are right if they have 63 bits at most.
    #[must_use]
    pub fn low_units(&self, points: &[[f64; D]]) -> Vec<[i64; D]> {
        #[allow(clippy::cast_possible_truncation)] // modulo 2^64
        points.iter().map(|point| point.map(|x| units(x, self.lowest) as i64)).collect()
    }
}

/// A multiple of 2^`lowest` in units of 2^`lowest`, modulo 2^128.
///
/// Differences are right if they have 127 bits at most, however far from the origin the points are.
#[inline]
#[must_use]
pub fn units(x: f64, lowest: i32) -> i128 {
    let Parts { negative, significand, exponent } = Parts::of_any(x);
    // A right shift drops only zeros; for zero any shift is right.
    let shift = (exponent - lowest).unsigned_abs();
    let magnitude = if exponent >= lowest {
        u128::from(significand).checked_shl(shift).unwrap_or(0)
    } else {
        u128::from(significand.checked_shr(shift).unwrap_or(0))
    };
    let units = magnitude.cast_signed();
    if negative { units.wrapping_neg() } else { units }
}

/// The distance |a − b|, rounded up; infinite if no double is large enough.
///
/// The rounding error of a difference is a double, and Knuth's two-sum finds it. The error is lost only if the
/// difference itself overflows.
#[must_use]
pub fn difference_up(a: f64, b: f64) -> f64 {
    let difference = (a - b).abs();
    // (If the difference overflows, the tail is NaN.)
    if exact_tail(a.max(b), a.min(b), difference) > 0.0 { difference.next_up() } else { difference }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn range(values: &[f64]) -> (i32, i32) {
        let range = ExponentRange::of(values).unwrap();
        (range.lowest, range.highest)
    }

    #[test]
    fn known_values() {
        assert_eq!(ExponentRange::of(&[]), None);
        assert_eq!(ExponentRange::of(&[0.0, -0.0]), None);
        assert_eq!(range(&[1.0]), (0, 1));
        assert_eq!(range(&[0.0, -6.0]), (1, 3));
        assert_eq!(range(&[0.1]), (-55, -3));
        assert_eq!(range(&[5e-324]), (-1074, -1073));
        assert_eq!(range(&[f64::MIN_POSITIVE]), (-1022, -1021));
        assert_eq!(range(&[f64::MIN_POSITIVE.next_down()]), (-1074, -1022));
        assert_eq!(range(&[f64::MAX]), (971, 1024));
        assert_eq!(range(&[f64::MAX, 5e-324]), (-1074, 1024));
        assert_eq!(range(&[1.0, f64::INFINITY]).1, 1025);
        assert_eq!(range(&[f64::NAN]).1, 1025);
    }

    #[test]
    fn exact_differences_stay_and_others_go_up() {
        assert_eq!(difference_up(3.0, -1.0), 4.0);
        assert_eq!(difference_up(-1.0, 3.0), 4.0);
        assert_eq!(difference_up(1.0, -2.0_f64.powi(-53)), 1.0_f64.next_up());
        assert_eq!(difference_up(1.0, 2.0_f64.powi(-60)), 1.0);
        assert_eq!(difference_up(f64::MAX, -f64::MAX), f64::INFINITY);
        assert_eq!(difference_up(f64::MAX, -1.0), f64::INFINITY);
        assert_eq!(difference_up(5e-324, -5e-324), 1e-323);
    }
}
