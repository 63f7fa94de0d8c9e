//! Streams of random numbers, identical on every platform.

use rand_chacha::ChaCha8Rng;
use rand_core::{Rng, SeedableRng};
use sha2::{Digest, Sha256};

use crate::bits::power_of_two;

/// A stream of random numbers.
pub struct Random(ChaCha8Rng);

impl Random {
    /// The stream of one family, task and seed: streams of different families are independent, even with the same seed.
    #[must_use]
    pub fn new(family: &str, task: &str, seed: u64) -> Random {
        let mut digest = Sha256::new();
        for part in ["predicament", family, task] {
            digest.update(part.as_bytes());
            digest.update([0]);
        }
        digest.update(seed.to_le_bytes());
        Random(ChaCha8Rng::from_seed(digest.finalize().into()))
    }

    /// A random multiple of 2^-53 in [0, 1).
    pub fn unit(&mut self) -> f64 {
        #[allow(clippy::cast_precision_loss)] // 53 bits
        let integer = (self.0.next_u64() >> 11) as f64;
        integer * power_of_two(-53)
    }

    /// A uniform random number in [low, high), up to the rounding of the sum.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + self.unit() * (high - low)
    }

    /// A random double with the given exponent, 52 random bits and a random sign.
    pub fn mantissa(&mut self) -> f64 {
        let bits = self.0.next_u64();
        let magnitude = f64::from_bits((bits >> 12) | 1.0_f64.to_bits());
        if bits & 1 == 0 { magnitude } else { -magnitude }
    }

    /// A random integer from `low` to `high`, both included.
    pub fn integer(&mut self, low: i64, high: i64) -> i64 {
        let span = high.abs_diff(low) + 1;
        // Rejecting the incomplete last span keeps the distribution uniform.
        let limit = u64::MAX - u64::MAX % span;
        loop {
            let bits = self.0.next_u64();
            if bits < limit {
                return low + (bits % span).cast_signed();
            }
        }
    }

    /// A random integer from 1 to `high` with a random sign.
    pub fn nonzero(&mut self, high: i64) -> i64 {
        let magnitude = self.integer(1, high);
        if self.one_in(2) { magnitude } else { -magnitude }
    }

    /// Shuffles the items: all orders are equally likely, up to a bias of 2^-32 for each item.
    ///
    /// # Panics
    /// If there are 2^32 items or more.
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        assert!(u32::try_from(items.len()).is_ok(), "{} items are too many to shuffle", items.len());
        for last in (1..items.len()).rev() {
            // A multiplication replaces a division.
            #[allow(clippy::cast_possible_truncation)] // at most `last`
            let other = ((u64::from(self.0.next_u32()) * (last as u64 + 1)) >> 32) as usize;
            items.swap(last, other);
        }
    }

    /// True with probability 1/`n`.
    pub fn one_in(&mut self, n: i64) -> bool {
        self.integer(1, n) == 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stream_is_pinned() {
        let mut rng = Random::new("uniform", "orient2d", 7);
        let first: Vec<u64> = (0..3).map(|_| rng.0.next_u64()).collect();
        assert_eq!(first, PINNED);
        assert_ne!(Random::new("uniform", "orient2d", 8).0.next_u64(), first[0]);
        assert_ne!(Random::new("uniform", "incircle", 7).0.next_u64(), first[0]);
    }

    /// Computed by another implementation of SHA-256 and ChaCha8.
    const PINNED: [u64; 3] = [1_800_954_810_097_351_678, 7_239_506_916_973_882_769, 11_590_012_598_734_884_534];

    #[test]
    fn each_order_is_as_likely_as_any() {
        let mut rng = Random::new("test", "shuffle", 0);
        let mut counts = std::collections::BTreeMap::new();
        for _ in 0..6000 {
            let mut items = [0, 1, 2];
            rng.shuffle(&mut items);
            *counts.entry(items).or_insert(0) += 1;
        }
        assert_eq!(counts.len(), 6);
        // The mean is 1000; the standard deviation is 29.
        assert!(counts.values().all(|count| (850..1150).contains(count)), "{counts:?}");
    }

    #[test]
    fn ranges_are_met_at_both_ends_and_not_left() {
        let mut rng = Random::new("test", "test", 0);
        let drawn: std::collections::BTreeSet<i64> = (0..500).map(|_| rng.integer(-3, 4)).collect();
        assert_eq!(drawn.into_iter().collect::<Vec<_>>(), (-3..=4).collect::<Vec<_>>());
        for _ in 0..500 {
            assert!((1.0..2.0).contains(&rng.mantissa().abs()));
            assert!((0.0..1.0).contains(&rng.unit()));
            assert!(rng.nonzero(2) != 0);
        }
    }
}
