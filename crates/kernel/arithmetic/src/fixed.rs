//! Integers of a fixed number of limbs, on the stack.
//!
//! A scene whose coordinates span few bits needs only a few machine words for any determinant, and the number of words
//! is known before the first query. So nothing is allocated and there are no branches: additions are carry chains,
//! products are one multiplication per pair of limbs.
//!
//! Two's complement, least significant limb first. Sums wrap: an intermediate may leave the range if the final value is
//! in it. Products fit every value.

/// A signed integer of `L` limbs of 64 bits: −2^(64L−1) ..= 2^(64L−1) − 1.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Fixed<const L: usize>([u64; L]);

impl<const L: usize> Fixed<L> {
    /// The number zero.
    pub const ZERO: Fixed<L> = Fixed([0; L]);

    /// The number with these limbs, least significant first.
    #[inline(always)]
    #[must_use]
    pub const fn from_limbs(limbs: [u64; L]) -> Fixed<L> {
        Fixed(limbs)
    }

    /// The limbs, least significant first.
    #[must_use]
    pub const fn limbs(&self) -> &[u64; L] {
        &self.0
    }

    /// Returns true if the number is below zero.
    #[inline(always)]
    #[must_use]
    pub const fn is_negative(self) -> bool {
        self.0[L - 1] >> 63 == 1
    }

    /// Returns true if the number is zero.
    #[inline(always)]
    #[must_use]
    pub fn is_zero(self) -> bool {
        self.0.iter().fold(0, |any, limb| any | limb) == 0
    }

    /// The same number in `M` ≥ `L` limbs; a smaller `M` does not compile.
    #[inline(always)]
    #[must_use]
    pub fn extended<const M: usize>(self) -> Fixed<M> {
        const { assert!(L <= M, "no limb is left out") };
        let mut limbs = [if self.is_negative() { u64::MAX } else { 0 }; M];
        limbs[..L].copy_from_slice(&self.0);
        Fixed(limbs)
    }

    /// The sum, modulo 2^(64L).
    #[inline(always)]
    #[must_use]
    pub fn plus(self, other: Fixed<L>) -> Fixed<L> {
        let mut sum = [0; L];
        let mut carry = false;
        for (sum, (a, b)) in sum.iter_mut().zip(self.0.into_iter().zip(other.0)) {
            let (low, first) = a.overflowing_add(b);
            let (low, second) = low.overflowing_add(u64::from(carry));
            *sum = low;
            carry = first | second;
        }
        Fixed(sum)
    }

    /// The difference, modulo 2^(64L).
    #[inline(always)]
    #[must_use]
    pub fn minus(self, other: Fixed<L>) -> Fixed<L> {
        let mut difference = [0; L];
        let mut borrow = false;
        for (difference, (a, b)) in difference.iter_mut().zip(self.0.into_iter().zip(other.0)) {
            let (low, first) = a.overflowing_sub(b);
            let (low, second) = low.overflowing_sub(u64::from(borrow));
            *difference = low;
            borrow = first | second;
        }
        Fixed(difference)
    }

    /// The product, modulo 2^(64P).
    ///
    /// If `P` = `L` + `M`, the product fits completely. If `P` is smaller, the upper limbs are not computed. A larger
    /// `P` does not compile.
    #[inline(always)]
    #[must_use]
    pub fn times<const M: usize, const P: usize>(self, other: Fixed<M>) -> Fixed<P> {
        const { assert!(P <= L + M, "a product has the limbs of both factors at most") };
        // Row by row, the top limbs as signed numbers: after row i the lowest i + M + 1 limbs hold a signed number.
        let mut product = [0; P];
        for i in 0..L {
            let row = self.0[i];
            let mut carry = 0;
            for j in 0..M - 1 {
                if i + j >= P {
                    break;
                }
                // (2^64 − 1)² + 2(2^64 − 1) = 2^128 − 1: nothing is lost.
                if i == L - 1 {
                    let wide = signed(row) * unsigned(other.0[j]) + unsigned(product[i + j]) + carry;
                    product[i + j] = low(wide.cast_unsigned());
                    carry = wide >> 64;
                } else {
                    let wide =
                        u128::from(row) * u128::from(other.0[j]) + u128::from(product[i + j]) + carry.cast_unsigned();
                    product[i + j] = low(wide);
                    carry = (wide >> 64).cast_signed();
                }
            }
            if i + M > P {
                continue;
            }
            let factor = if i == L - 1 { signed(row) } else { unsigned(row) };
            let above = if i == 0 { 0 } else { signed(product[i + M - 1]) };
            let wide = factor * signed(other.0[M - 1]) + above + carry;
            product[i + M - 1] = low(wide.cast_unsigned());
            if i + M < P {
                product[i + M] = low((wide >> 64).cast_unsigned());
            }
        }
        Fixed(product)
    }
}

#[inline(always)]
const fn signed(limb: u64) -> i128 {
    limb.cast_signed() as i128
}

#[inline(always)]
const fn unsigned(limb: u64) -> i128 {
    limb as i128
}

#[inline(always)]
#[allow(clippy::cast_possible_truncation)] // keeps the lower half
const fn low(wide: u128) -> u64 {
    wide as u64
}

impl Fixed<1> {
    /// The value of a double that is an integer less than 2^63 in magnitude.
    #[inline(always)]
    #[must_use]
    pub fn from_double(x: f64) -> Fixed<1> {
        #[allow(clippy::cast_possible_truncation)] // an integer in range
        let integer = x as i64;
        Fixed::from(integer)
    }

    /// The double nearest to the number.
    #[inline(always)]
    #[must_use]
    #[allow(clippy::cast_precision_loss)] // rounds to nearest
    pub const fn to_double(self) -> f64 {
        self.0[0].cast_signed() as f64
    }
}

impl From<i64> for Fixed<1> {
    #[inline(always)]
    fn from(value: i64) -> Fixed<1> {
        Fixed([value.cast_unsigned()])
    }
}

impl From<i128> for Fixed<2> {
    #[inline(always)]
    fn from(value: i128) -> Fixed<2> {
        let bits = value.cast_unsigned();
        Fixed([low(bits), low(bits >> 64)])
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use rug::Integer;

    use super::*;

    fn value<const L: usize>(x: Fixed<L>) -> Integer {
        let unsigned = Integer::from_digits(x.limbs(), rug::integer::Order::Lsf);
        if x.is_negative() { unsigned - (Integer::from(1) << (64 * u32::try_from(L).unwrap())) } else { unsigned }
    }

    /// Limbs that are often all zeros, all ones or a single bit.
    fn limb() -> impl Strategy<Value = u64> {
        prop_oneof![any::<u64>(), Just(0), Just(u64::MAX), (0..64_u32).prop_map(|bit| 1 << bit)]
    }

    fn fixed<const L: usize>() -> impl Strategy<Value = Fixed<L>> {
        prop::array::uniform(limb()).prop_map(Fixed::from_limbs)
    }

    fn check<const A: usize, const B: usize, const P: usize>(a: Fixed<A>, b: Fixed<B>) {
        let product: Fixed<P> = a.times(b);
        // (The full product if P = A + B, else modulo 2^(64P).)
        let bits = 64 * u32::try_from(P.min(A + B)).unwrap();
        assert_eq!(value(product), (value(a) * value(b)).keep_signed_bits(bits));
        assert!(P < A + B || value(product) == value(a) * value(b));
        assert_eq!(a.is_zero(), value(a).is_zero());
    }

    #[test]
    fn conversions() {
        for x in [0, 1, -1, i64::MIN, i64::MAX] {
            assert_eq!(value(Fixed::from(x)), x);
            assert_eq!(value(Fixed::from(i128::from(x) << 64)), Integer::from(x) << 64);
        }
        assert_eq!(value(Fixed::from(i128::MIN)), i128::MIN);
        for x in [0.0, -0.0, 1.0, -1.0, 9_007_199_254_740_993.0, -9.2e18, 9_223_372_036_854_774_784.0] {
            assert_eq!(value(Fixed::<1>::from_double(x)), Integer::from_f64(x).unwrap());
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(2000)))]

        #[test]
        fn products_are_those_of_gmp(
            a in fixed::<1>(), b in fixed::<2>(), c in fixed::<3>(), d in fixed::<4>(), e in fixed::<6>(),
        ) {
            check::<1, 1, 2>(a, a);
            check::<2, 1, 3>(b, a);
            check::<2, 2, 4>(b, b);
            check::<3, 2, 5>(c, b);
            check::<4, 2, 6>(d, b);
            check::<4, 4, 8>(d, d);
            check::<6, 4, 10>(e, d);
            check::<1, 1, 1>(a, a);
            check::<2, 1, 2>(b, a);
            check::<2, 1, 1>(b, a);
            check::<2, 2, 2>(b, b);
            check::<2, 2, 3>(b, b);
            check::<3, 2, 4>(c, b);
            check::<3, 2, 3>(c, b);
            check::<2, 3, 2>(b, c);
            check::<4, 4, 5>(d, d);
        }

        #[test]
        fn more_limbs_are_the_same_number(a in fixed::<1>(), b in fixed::<2>(), c in fixed::<3>()) {
            prop_assert_eq!([value(a.extended::<1>()), value(a.extended::<4>())], [value(a), value(a)]);
            prop_assert_eq!([value(b.extended::<2>()), value(b.extended::<3>())], [value(b), value(b)]);
            prop_assert_eq!(value(c.extended::<8>()), value(c));
        }

        #[test]
        fn sums_wrap(a in fixed::<3>(), b in fixed::<3>()) {
            let wrapped = |x: Integer| x.keep_signed_bits(192);
            prop_assert_eq!(value(a.plus(b)), wrapped(value(a) + value(b)));
            prop_assert_eq!(value(a.minus(b)), wrapped(value(a) - value(b)));
        }
    }
}
