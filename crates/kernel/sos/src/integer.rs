//! Integers of any length; those of 128 bits allocate nothing.
//!
//! Coefficients of perturbed determinants are mostly short: they begin as the significands of a few coordinates, and
//! zeros are the point of a tie.

use std::cmp::Ordering;
use std::ops::{Add, AddAssign, Mul, Neg, Shl, Sub, SubAssign};

use predicament_arithmetic::BigInt;

/// An integer of any length.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Integer {
    /// Every integer of 128 bits.
    Short(Short),
    /// Every other integer.
    Long(BigInt),
}

/// An integer of 128 bits, stored as densely as the limbs of a longer one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[repr(Rust, packed(8))]
pub(crate) struct Short(i128);

use Integer::Long;

/// The short integer.
#[inline(always)]
fn short(x: i128) -> Integer {
    Integer::Short(Short(x))
}

/// The long integer, or the short one if it has 128 bits.
#[allow(clippy::cast_possible_wrap)] // the highest bit is zero
fn normal(x: BigInt) -> Integer {
    let magnitude = match *x.limbs() {
        [] => 0,
        [low] => u128::from(low),
        [low, high] => u128::from(high) << 64 | u128::from(low),
        _ => return Long(x),
    };
    let limit = 1 << 127;
    match x.is_negative() {
        true if magnitude <= limit => short((magnitude as i128).wrapping_neg()),
        false if magnitude < limit => short(magnitude as i128),
        _ => Long(x),
    }
}

/// The product of short integers, if it is short.
#[inline(always)]
fn product(x: i128, y: i128) -> Option<i128> {
    match (i64::try_from(x), i64::try_from(y)) {
        (Ok(x), Ok(y)) => Some(i128::from(x) * i128::from(y)),
        _ => x.checked_mul(y),
    }
}

impl Integer {
    /// Zero.
    pub(crate) const ZERO: Integer = Integer::Short(Short(0));
    /// One.
    pub(crate) const ONE: Integer = Integer::Short(Short(1));

    /// The integer, if it is short.
    #[inline(always)]
    fn short(&self) -> Option<i128> {
        match *self {
            Integer::Short(Short(x)) => Some(x),
            Long(_) => None,
        }
    }

    /// Returns true for zero.
    #[inline(always)]
    pub(crate) fn is_zero(&self) -> bool {
        matches!(self, Integer::Short(Short(0)))
    }

    /// The order of the integer and zero.
    pub(crate) fn cmp0(&self) -> Ordering {
        match self {
            &Integer::Short(Short(x)) => x.cmp(&0),
            Long(x) => x.cmp0(),
        }
    }

    /// The integer with its limbs.
    pub(crate) fn into_limbs(self) -> BigInt {
        match self {
            Integer::Short(_) => {
                let mut space = [0; 2];
                let (negative, limbs) = self.parts(&mut space);
                BigInt::new(negative, limbs.to_vec())
            }
            Long(x) => x,
        }
    }

    /// The sign and the limbs of the magnitude, of a short integer in the space that is given.
    #[inline]
    #[allow(clippy::cast_possible_truncation)] // halves of 128 bits
    fn parts<'x>(&'x self, space: &'x mut [u64; 2]) -> (bool, &'x [u64]) {
        match self {
            &Integer::Short(Short(x)) => {
                let magnitude = x.unsigned_abs();
                *space = [magnitude as u64, (magnitude >> 64) as u64];
                let length = space.iter().rposition(|&limb| limb != 0).map_or(0, |last| last + 1);
                (x < 0, &space[..length])
            }
            Long(x) => (x.is_negative(), x.limbs()),
        }
    }

    /// Adds an integer in place, or subtracts it.
    #[inline(never)]
    fn add_long(&mut self, other: &Integer, minus: bool) {
        if other.is_zero() {
            return;
        }
        let mut sum = std::mem::replace(self, Integer::ZERO).into_limbs();
        let mut space = [0; 2];
        let (negative, limbs) = other.parts(&mut space);
        sum.add_magnitude(negative != minus, limbs);
        *self = normal(sum);
    }

    /// Adds a product in place.
    #[inline]
    pub(crate) fn add_product(&mut self, a: &Integer, b: &Integer) {
        if let (Some(sum), Some(x), Some(y)) = (self.short(), a.short(), b.short())
            && let Some(sum) = product(x, y).and_then(|product| sum.checked_add(product))
        {
            *self = short(sum);
            return;
        }
        self.add_long_product(a, b);
    }

    #[inline(never)]
    fn add_long_product(&mut self, a: &Integer, b: &Integer) {
        if a.is_zero() || b.is_zero() {
            return;
        }
        let mut sum = std::mem::replace(self, Integer::ZERO).into_limbs();
        let (mut first, mut second) = ([0; 2], [0; 2]);
        let ((a_negative, a), (b_negative, b)) = (a.parts(&mut first), b.parts(&mut second));
        sum.add_product_of(a_negative != b_negative, a, b);
        *self = normal(sum);
    }

    /// The greatest common divisor, not negative; that of zero and a number is the number's magnitude.
    pub(crate) fn gcd(&self, other: &Integer) -> Integer {
        if let (Some(x), Some(y)) = (self.short(), other.short()) {
            let (mut x, mut y) = (x.unsigned_abs(), y.unsigned_abs());
            while y != 0 {
                (x, y) = (y, remainder(x, y));
            }
            if let Ok(x) = i128::try_from(x) {
                return short(x);
            }
        }
        normal(self.clone().into_limbs().gcd(&other.clone().into_limbs()))
    }

    /// The quotient by a divisor of the integer; the divisor is not zero.
    pub(crate) fn div_exact(&self, divisor: &Integer) -> Integer {
        if let (Some(x), Some(y)) = (self.short(), divisor.short())
            && let Some(quotient) = x.checked_div(y)
        {
            return short(quotient);
        }
        normal(self.clone().into_limbs().div_exact(&divisor.clone().into_limbs()))
    }
}

/// The remainder, in one limb if that suffices.
#[inline(always)]
fn remainder(x: u128, y: u128) -> u128 {
    match (u64::try_from(x), u64::try_from(y)) {
        (Ok(x), Ok(y)) => u128::from(x % y),
        _ => x % y,
    }
}

impl From<i64> for Integer {
    fn from(x: i64) -> Integer {
        short(i128::from(x))
    }
}

/// The product with a power of two.
impl Shl<u32> for Integer {
    type Output = Integer;

    fn shl(self, places: u32) -> Integer {
        if let Some(x) = self.short()
            && let bits = i128::BITS - x.unsigned_abs().leading_zeros()
            && bits + places < i128::BITS
        {
            return short(x << places);
        }
        normal(self.into_limbs() << places)
    }
}

impl Neg for Integer {
    type Output = Integer;

    fn neg(self) -> Integer {
        match self.short().and_then(i128::checked_neg) {
            Some(x) => short(x),
            None => normal(-self.into_limbs()),
        }
    }
}

impl Add for &Integer {
    type Output = Integer;

    #[inline]
    fn add(self, other: &Integer) -> Integer {
        let mut sum = self.clone();
        sum += other;
        sum
    }
}

impl Sub for &Integer {
    type Output = Integer;

    #[inline]
    fn sub(self, other: &Integer) -> Integer {
        let mut difference = self.clone();
        difference -= other;
        difference
    }
}

impl Mul for &Integer {
    type Output = Integer;

    #[inline]
    fn mul(self, other: &Integer) -> Integer {
        let mut product = Integer::ZERO;
        product.add_product(self, other);
        product
    }
}

impl AddAssign<&Integer> for Integer {
    #[inline]
    fn add_assign(&mut self, other: &Integer) {
        match self.short().zip(other.short()).and_then(|(x, y)| x.checked_add(y)) {
            Some(sum) => *self = short(sum),
            None => self.add_long(other, false),
        }
    }
}

impl SubAssign<&Integer> for Integer {
    #[inline]
    fn sub_assign(&mut self, other: &Integer) {
        match self.short().zip(other.short()).and_then(|(x, y)| x.checked_sub(y)) {
            Some(difference) => *self = short(difference),
            None => self.add_long(other, true),
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use proptest::prelude::*;
    use rug::integer::Order;

    use super::*;

    /// The integer of GMP.
    pub(crate) fn value(x: &Integer) -> rug::Integer {
        let x = x.clone().into_limbs();
        let magnitude = rug::Integer::from_digits(x.limbs(), Order::Lsf);
        if x.is_negative() { -magnitude } else { magnitude }
    }

    /// Asserts that a result is the reference, and short exactly if it has 128 bits.
    fn same(x: &Integer, reference: rug::Integer) {
        assert_eq!(value(x), reference);
        assert_eq!(matches!(x, Integer::Short(_)), reference.to_i128().is_some(), "{reference}");
        assert_eq!(x.cmp0(), reference.cmp0());
        assert_eq!(x.is_zero(), reference.is_zero());
    }

    /// Numbers about the ends of 64 and of 128 bits, and any other.
    fn integer() -> impl Strategy<Value = Integer> {
        let ends = prop_oneof![Just(0), Just(63), Just(64), Just(126), Just(127), Just(128), Just(190), 0..300_u32];
        (any::<bool>(), ends, -2..=2_i64, any::<i64>(), any::<bool>()).prop_map(
            |(negative, places, ulps, any, is_any)| {
                let x = &(Integer::ONE << places) + &Integer::from(if is_any { any } else { ulps });
                if negative { -x } else { x }
            },
        )
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(predicament_effort::cases(3000)))]

        #[test]
        fn integers_are_those_of_gmp(a in integer(), b in integer(), c in integer(), places in 0..200_u32) {
            let [x, y, z] = [&a, &b, &c].map(value);
            same(&a, x.clone());
            same(&(&a + &b), rug::Integer::from(&x + &y));
            same(&(&a - &b), rug::Integer::from(&x - &y));
            same(&(&a * &b), rug::Integer::from(&x * &y));
            same(&-a.clone(), -x.clone());
            same(&(a.clone() << places), x.clone() << places);
            same(&a.gcd(&b), rug::Integer::from(x.gcd_ref(&y)));
            if !b.is_zero() {
                same(&(&a * &b).div_exact(&b), x.clone());
            }
            let (mut plus, mut minus, mut sum) = (a.clone(), a.clone(), a);
            plus += &b;
            minus -= &b;
            sum.add_product(&b, &c);
            same(&plus, rug::Integer::from(&x + &y));
            same(&minus, rug::Integer::from(&x - &y));
            same(&sum, x + y * z);
        }
    }

    #[test]
    fn an_integer_is_as_large_as_the_limbs_of_a_long_one() {
        assert_eq!(size_of::<Integer>(), size_of::<BigInt>());
    }
}
