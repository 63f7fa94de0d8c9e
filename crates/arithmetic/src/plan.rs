//! What the exponents of a scene prove about arithmetic on it.
//!
//! Floating-point filters and expansions are right as long as nothing
//! overflows and nothing underflows. Both can be known in advance, from two
//! exponents and the degree of what will be computed.
//!
//! # The proof
//! Let every coordinate be a multiple of 2^l and less than 2^h in magnitude
//! ([`ExponentRange`]), and let an algorithm only take sums, differences and
//! products, so that each of its intermediates is homogeneous of some degree
//! 1 ≤ j ≤ k in the coordinates.
//!
//! **Granularity.** Sums and differences of multiples of 2^g are multiples of
//! 2^g; products of multiples of 2^g and 2^g′ are multiples of 2^(g+g′). A
//! double nearest to a multiple of 2^g is a multiple of 2^g itself: either the
//! value is representable, or the doubles around it lie on a coarser grid. By
//! induction each intermediate of degree j, *rounded or not, tails included*,
//! is a multiple of 2^(j·l). The subnormal grid is 2^-1074, so as long as
//! j·l ≥ -1074 for all j, tiny results are exact: no tail of a sum or
//! product is lost. (Splitting a factor in two halves keeps its granularity: a
//! factor of 26 bits or fewer is its own upper half; of a longer one the lower
//! half takes the bits that are there.)
//!
//! **Bounds.** Filters multiply a sum of degree k by a constant, u = 2^-53
//! times a small number in first stages and its square in later ones. For these
//! products to be rounded as usual they must not be subnormal, unless zero:
//! k·l − 106 ≥ -1022, or **k·l ≥ -916**, which implies the above. (For l > 0
//! there's nothing to lose.)
//!
//! **Magnitude.** Differences are less than M = 2^(h+1). If every intermediate
//! of degree j is less than 2^growth · M^j, then none overflows when
//! j·(h + 1) + growth ≤ 1023. Shewchuk's splitter multiplies factors by
//! 2^27 + 1 < 2^28, so **max(k·(h + 1), 0) + growth + 28 ≤ 1023** suffices for
//! all degrees at once; the rounding of sums, a relative u each, is covered by
//! taking growth with room to spare.
//!
//! **Exactness.** An intermediate of degree j is a multiple of 2^(j·l) and less
//! than 2^(j·(h+1) + growth). If **k·(h + 1 − l) + growth ≤ 53** it has 53 bits
//! at most, for each j (since h + 1 > l), and plain floating point makes no
//! error at all.

use crate::ExponentRange;

/// The lowest exponent that a non-zero sum may have for its product with u² to be normal.
const LOWEST: i32 = -1022 + 2 * 53;
/// The exponent that no intermediate may reach, less Shewchuk's splitter.
const HIGHEST: i32 = 1023 - 28;
/// The bits of a double.
const PRECISION: i32 = 53;

/// A polynomial in differences of coordinates, as far as ranges are concerned.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Form {
    /// The degree: how many differences each term multiplies.
    pub degree: i32,
    /// How far sums grow: an intermediate of degree j is less than
    /// 2^`growth` · M^j, if all differences are less than M.
    pub growth: i32,
}

/// What is proved about floating-point evaluation of a [`Form`].
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Regime {
    /// Every intermediate is a double: plain evaluation makes no error.
    Exact,
    /// Nothing overflows or underflows: filters and expansions are right.
    Safe,
    /// Nothing is proved.
    Unproved,
}

/// A list of coordinates, reduced to what can be proved about it.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Plan {
    range: Option<ExponentRange>,
}

impl Plan {
    /// The plan for these coordinates.
    #[must_use]
    pub fn of<'a>(coordinates: impl IntoIterator<Item = &'a f64>) -> Plan {
        Plan { range: ExponentRange::of(coordinates) }
    }

    /// The exponents of the coordinates; none if all are zero.
    #[must_use]
    pub fn range(&self) -> Option<ExponentRange> {
        self.range
    }

    /// What is proved for this form; see the source of this module for the proof.
    #[must_use]
    pub fn regime(&self, form: Form) -> Regime {
        let Some(ExponentRange { lowest, highest }) = self.range else {
            return Regime::Exact;
        };
        let Form { degree, growth } = form;
        let no_underflow = degree * lowest >= LOWEST;
        let no_overflow = (degree * (highest + 1)).max(0) + growth <= HIGHEST;
        if !(no_underflow && no_overflow) {
            Regime::Unproved
        } else if degree * (highest + 1 - lowest) + growth <= PRECISION {
            Regime::Exact
        } else {
            Regime::Safe
        }
    }
}
