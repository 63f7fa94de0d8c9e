//! Integers modulo the Mersenne prime 2^61 − 1, to guess whether a polynomial is zero, and to prove it for small ones.

/// The exponent of the prime.
const E: u32 = 61;

/// An integer modulo the prime, from 0 on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Residue(u64);

impl Residue {
    const PRIME: u64 = (1 << E) - 1;

    /// The number of bits of the prime: a magnitude of fewer bits is zero if its residue is.
    pub(super) const BITS: u32 = E;
    pub(super) const ZERO: Residue = Residue(0);
    pub(super) const ONE: Residue = Residue(1);

    /// The residue of any integer of 64 bits.
    pub(super) const fn new(n: u64) -> Residue {
        Residue(n % Self::PRIME)
    }

    /// The residue of m · 2^k.
    pub(super) fn scaled(m: i64, k: u32) -> Residue {
        let magnitude = Residue::new(m.unsigned_abs()).times(Residue(1 << (k % E)));
        if m < 0 { Residue::ZERO.minus(magnitude) } else { magnitude }
    }

    pub(super) const fn is_zero(self) -> bool {
        self.0 == 0
    }

    pub(super) const fn plus(self, other: Residue) -> Residue {
        let sum = self.0 + other.0;
        Residue(if sum >= Self::PRIME { sum - Self::PRIME } else { sum })
    }

    pub(super) const fn minus(self, other: Residue) -> Residue {
        Residue(if self.0 >= other.0 { self.0 - other.0 } else { self.0 + Self::PRIME - other.0 })
    }

    #[allow(clippy::cast_possible_truncation)] // halves of E bits
    pub(super) const fn times(self, other: Residue) -> Residue {
        let product = self.0 as u128 * other.0 as u128;
        let (low, high) = (product as u64 & Self::PRIME, (product >> E) as u64);
        Residue(low).plus(Residue(high))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use rug::Integer;

    use super::*;

    fn check(a: u64, b: u64, m: i64, k: u32) {
        let prime = (Integer::from(1) << E) - 1;
        let modulo = |n: Integer| (n % &prime + &prime) % &prime;
        let [x, y] = [a, b].map(Residue::new);
        let [a, b] = [a, b].map(Integer::from);
        assert_eq!(x.plus(y).0, modulo(Integer::from(&a + &b)));
        assert_eq!(x.minus(y).0, modulo(Integer::from(&a - &b)));
        assert_eq!(x.times(y).0, modulo(a * b));
        assert_eq!(Residue::scaled(m, k).0, modulo(Integer::from(m) << k));
    }

    proptest! {
        #[test]
        fn arithmetic_is_that_of_integers_modulo_the_prime(a: u64, b: u64, m: i64, k in 0_u32..2200) {
            check(a, b, m, k);
            for edge in [0, 1, (1 << 61) - 2, (1 << 61) - 1, u64::MAX] {
                check(a, edge, i64::MIN, k);
                check(edge, b, i64::MAX, k);
            }
        }
    }
}
