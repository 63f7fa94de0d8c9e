//! Equal steps along one axis of a grid.
//!
//! # Why nothing is missed
//! One function maps coordinates to steps. It is a subtraction, a multiplication and a truncation. All are rounded
//! monotonically, so the function is monotone for any rounding: low ≤ x ≤ high implies step(low) ≤ step(x) ≤
//! step(high), and step(x) < step(y) implies x < y. A coordinate exactly on a border or an extent near the ends of the
//! exponent range can't break that; at worst all coordinates share a step.

/// A monotone map from coordinates to 0, 1, 2 … count − 1.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Steps {
    /// Half the smallest coordinate; halves can't overflow when they are subtracted.
    origin: f64,
    /// Steps per half unit; never infinite, or the smallest coordinate would make 0 · ∞.
    scale: f64,
    count: usize,
}

impl Steps {
    /// Steps over an extent; an extent of 0 has one step.
    #[allow(clippy::cast_precision_loss)] // any monotone map will do
    pub(crate) fn new([low, high]: [f64; 2], count: usize) -> Steps {
        let half_extent = high / 2.0 - low / 2.0;
        if half_extent > 0.0 {
            Steps { origin: low / 2.0, scale: (count as f64 / half_extent).min(f64::MAX), count }
        } else {
            Steps { origin: 0.0, scale: 0.0, count: 1 }
        }
    }

    pub(crate) fn count(&self) -> usize {
        self.count
    }

    /// Half as many steps over the same extent.
    pub(crate) fn coarser(&self) -> Steps {
        let count = self.count.div_ceil(2);
        #[allow(clippy::cast_precision_loss)] // any monotone map will do
        let scale = self.scale * (count as f64 / self.count as f64);
        Steps { scale, count, ..*self }
    }

    /// The approximate bounds of a step: good enough for choosing a finer grid, not for decisions.
    #[allow(clippy::cast_precision_loss)] // about
    pub(crate) fn about(&self, step: usize) -> [f64; 2] {
        if self.scale == 0.0 {
            return [f64::MIN, f64::MAX];
        }
        let start = |step: usize| ((self.origin + step as f64 / self.scale) * 2.0).clamp(f64::MIN, f64::MAX);
        [start(step), start(step + 1)]
    }

    /// A coordinate about in the middle of the steps from `first` to `last`; `None` if they do not contain a double.
    pub(crate) fn middle(&self, first: usize, last: usize) -> Option<f64> {
        let [low, high] = [self.about(first)[0], self.about(last)[1]];
        let middle = low / 2.0 + high / 2.0;
        if (first..=last).contains(&self.of(middle)) {
            return Some(middle);
        }
        // Bisection: doubles and their bits have the same order, on each side of zero.
        let double = |key: i64| f64::from_bits((key ^ ((key >> 63) & i64::MAX)).cast_unsigned());
        let [mut below, mut above] =
            [f64::MIN, f64::MAX].map(|x| x.to_bits().cast_signed()).map(|bits| bits ^ ((bits >> 63) & i64::MAX));
        while below <= above {
            let key = below.midpoint(above);
            let x = double(key);
            match self.of(x) {
                step if step < first => below = key + 1,
                step if step > last => above = key - 1,
                _ => return Some(x),
            }
        }
        None
    }

    /// The step of a coordinate; a coordinate outside of the extent goes to the nearest step.
    #[inline]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // `as` saturates, which is the clamp we want
    pub(crate) fn of(&self, x: f64) -> usize {
        (((x / 2.0 - self.origin) * self.scale) as usize).min(self.count - 1)
    }
}

impl Steps {
    /// A faster [`Steps::of`] for fewer than 2^32 steps, by a conversion to 32 bits.
    #[inline]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // `as` saturates, which is the clamp we want
    pub(crate) fn short(&self, x: f64) -> u32 {
        (((x / 2.0 - self.origin) * self.scale) as u32).min((self.count - 1) as u32)
    }
}

/// The smallest and the largest of some coordinates; (∞, −∞) if there are none.
pub(crate) fn extent(coordinates: impl Iterator<Item = f64>) -> [f64; 2] {
    coordinates.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
}
