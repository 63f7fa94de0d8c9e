//! Exact numbers with an exponent of their own, on the stack.
//!
//! A double is an integer times a power of two, and so is every sum and every
//! product of doubles. [`Dyadic`] holds such numbers without rounding and
//! without allocating: as many 64-bit limbs as its capacity says, and the place
//! of the lowest one. The place keeps products of far-away numbers short
//! (2^−1000 · 2^−1000 is one limb), and since places count whole limbs, numbers
//! are added without shifting bits.
//!
//! # Capacity
//! is part of the type, because a number's size in memory is paid for whenever
//! it is made or moved. Results have a capacity of their own: the difference
//! of coordinates is small, a determinant is not. What fits is for the caller to
//! prove; what does not fit panics, and never wraps.
//!
//! A number needs the limbs from its lowest to its highest set bit; a sum the
//! limbs from the lower of the lowest to the higher of the highest, and one more
//! only if a carry leaves them; a product as many as both factors together. So
//! **if all inputs are integers below 2^(64n − 3), each in magnitude, an
//! intermediate of degree j fits into j·n limbs**: differences are below
//! 2^(64n − 2), products of j of them below 2^(64jn − 2j), and that leaves room
//! to add up 2^(2j) of them. The lengths of factors add up the same way.
//! Any one power of two may be taken out of the inputs beforehand
//! ([`Dyadic::from_f64_scaled`]), as signs of homogeneous polynomials don't see it;
//! all finite doubles are then integers below 2^2098, and n = 33 is enough for
//! everything.

mod limbs;

use std::cmp::Ordering;
use std::ops::Neg;

use limbs::{Header, View};
use rug::{Integer, Rational, integer::Order};

use crate::range::decompose;

/// ± magnitude · 2^exponent, with a magnitude of at most `CAP` limbs of 64 bits.
///
/// Its documentation in the source proves what fits. Numbers are large: the
/// `assign_…` methods write into one that is already there.
#[derive(Clone, Debug)]
pub struct Dyadic<const CAP: usize> {
    header: Header,
    /// Beyond the header's length they mean nothing.
    limbs: [u64; CAP],
}

impl<const CAP: usize> Dyadic<CAP> {
    /// Zero.
    pub const ZERO: Dyadic<CAP> = Dyadic { header: Header::ZERO, limbs: [0; CAP] };

    /// The value of a double; none for NaN and infinity.
    ///
    /// # Panics
    /// If the capacity is exceeded: two limbs hold every double.
    #[inline(always)]
    #[must_use]
    pub fn from_f64(x: f64) -> Option<Dyadic<CAP>> {
        x.is_finite().then(|| Dyadic::from_f64_scaled(x, 0))
    }

    /// x · 2^−`exponent`, of a finite x. (Others count as if they were some
    /// number of 2^1024 or more, as in [`ExponentRange`](crate::ExponentRange).)
    ///
    /// # Panics
    /// If the capacity is exceeded: two limbs hold every double, and one those
    /// whose bits lie between two multiples of 2^(`exponent` + 64).
    #[inline(always)]
    #[must_use]
    pub fn from_f64_scaled(x: f64, exponent: i32) -> Dyadic<CAP> {
        let (significand, own) = decompose(x);
        Dyadic::new(x.is_sign_negative(), significand, own.checked_sub(exponent).expect("the exponent fits"))
    }

    /// ± `significand` · 2^`exponent`.
    ///
    /// # Panics
    /// If the capacity is exceeded: two limbs are always enough.
    #[inline(always)]
    #[must_use]
    pub fn new(negative: bool, significand: u64, exponent: i32) -> Dyadic<CAP> {
        let mut number = Dyadic::ZERO;
        number.header = limbs::write(&mut number.limbs, negative, significand, exponent);
        number
    }

    /// a + b.
    ///
    /// # Panics
    /// If the capacity is exceeded.
    #[inline(always)]
    #[must_use]
    pub fn sum<const A: usize, const B: usize>(a: &Dyadic<A>, b: &Dyadic<B>) -> Dyadic<CAP> {
        let mut sum = Dyadic::ZERO;
        sum.assign_sum(a, b);
        sum
    }

    /// a − b.
    ///
    /// # Panics
    /// If the capacity is exceeded.
    #[inline(always)]
    #[must_use]
    pub fn difference<const A: usize, const B: usize>(a: &Dyadic<A>, b: &Dyadic<B>) -> Dyadic<CAP> {
        let mut difference = Dyadic::ZERO;
        difference.assign_difference(a, b);
        difference
    }

    /// a · b.
    ///
    /// # Panics
    /// If the capacity is exceeded: as many limbs are needed as both factors
    /// have together.
    #[inline(always)]
    #[must_use]
    pub fn product<const A: usize, const B: usize>(a: &Dyadic<A>, b: &Dyadic<B>) -> Dyadic<CAP> {
        let mut product = Dyadic::ZERO;
        product.assign_product(a, b);
        product
    }

    /// a².
    ///
    /// # Panics
    /// As [`Dyadic::product`].
    #[inline(always)]
    #[must_use]
    pub fn square<const A: usize>(a: &Dyadic<A>) -> Dyadic<CAP> {
        Dyadic::product(a, a)
    }

    /// Becomes a + b; see [`Dyadic::sum`].
    #[inline(always)]
    pub fn assign_sum<const A: usize, const B: usize>(&mut self, a: &Dyadic<A>, b: &Dyadic<B>) {
        self.header = limbs::sum(&mut self.limbs, a.view(), b.view());
    }

    /// Becomes a − b; see [`Dyadic::difference`].
    #[inline(always)]
    pub fn assign_difference<const A: usize, const B: usize>(&mut self, a: &Dyadic<A>, b: &Dyadic<B>) {
        let b = b.view();
        self.header = limbs::sum(&mut self.limbs, a.view(), View { negative: !b.negative && !b.limbs.is_empty(), ..b });
    }

    /// Becomes a · b; see [`Dyadic::product`].
    #[inline(always)]
    pub fn assign_product<const A: usize, const B: usize>(&mut self, a: &Dyadic<A>, b: &Dyadic<B>) {
        self.header = limbs::product(&mut self.limbs, a.view(), b.view());
    }

    /// Whether the number is zero.
    #[inline(always)]
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.header.len == 0
    }

    /// How the number compares to zero.
    #[inline]
    #[must_use]
    pub fn cmp0(&self) -> Ordering {
        match (self.is_zero(), self.header.negative) {
            (true, _) => Ordering::Equal,
            (false, true) => Ordering::Less,
            (false, false) => Ordering::Greater,
        }
    }

    /// How many limbs are in use: what the number costs, at most `CAP`.
    #[inline]
    #[must_use]
    pub fn limbs(&self) -> usize {
        self.header.len
    }

    /// The value as a rational, for judges: it allocates.
    ///
    /// # Panics
    /// If the exponent is beyond what rationals hold, some 2^31 bits.
    #[must_use]
    pub fn to_rational(&self) -> Rational {
        let View { negative, place, limbs } = self.view();
        let magnitude = Rational::from(Integer::from_digits(limbs, Order::Lsf));
        let shifted = magnitude << place.checked_mul(64).expect("the exponent fits");
        if negative { -shifted } else { shifted }
    }

    #[inline(always)]
    fn view(&self) -> View<'_> {
        let Header { negative, place, len } = self.header;
        View { negative, place, limbs: &self.limbs[..len] }
    }
}

impl<const CAP: usize> Neg for Dyadic<CAP> {
    type Output = Dyadic<CAP>;

    #[inline(always)]
    fn neg(mut self) -> Dyadic<CAP> {
        self.header.negative = !self.header.negative && !self.is_zero();
        self
    }
}

/// Equality of values, whatever the capacities.
impl<const A: usize, const B: usize> PartialEq<Dyadic<B>> for Dyadic<A> {
    fn eq(&self, other: &Dyadic<B>) -> bool {
        self.header == other.header && self.view().limbs == other.view().limbs
    }
}

impl<const CAP: usize> Eq for Dyadic<CAP> {}
