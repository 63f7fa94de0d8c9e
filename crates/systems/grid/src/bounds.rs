//! Axis-parallel boxes, and a conservative test of nearness.
//!
//! # Why no near pair is missed
//! Two boxes are near if along every axis the gap between them, as computed, is at most the reach. A difference is
//! rounded monotonically and the reach is a double. So if the true gap is at most the reach, the computed gap is too.
//! If a gap overflows to infinity, it is larger than every double. With reach zero the rule is exact, as a difference
//! of doubles is rounded to zero only if it is zero: closed boxes that touch are near.

/// A closed box with sides along the axes; a point is also a box.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Bounds<const D: usize> {
    /// The lowest coordinate along each axis.
    pub low: [f64; D],
    /// The highest coordinate along each axis.
    pub high: [f64; D],
}

impl<const D: usize> Bounds<D> {
    /// The empty box, the identity of union.
    pub const NOTHING: Bounds<D> = Bounds { low: [f64::INFINITY; D], high: [f64::NEG_INFINITY; D] };

    /// The smallest box that holds all these points.
    #[must_use]
    pub fn of(points: impl IntoIterator<Item = [f64; D]>) -> Bounds<D> {
        let one = |point| Bounds { low: point, high: point };
        points.into_iter().fold(Bounds::NOTHING, |all, point| all.union(&one(point)))
    }

    /// The smallest box that holds both.
    #[inline]
    #[must_use]
    pub fn union(&self, other: &Bounds<D>) -> Bounds<D> {
        Bounds {
            low: std::array::from_fn(|axis| self.low[axis].min(other.low[axis])),
            high: std::array::from_fn(|axis| self.high[axis].max(other.high[axis])),
        }
    }

    /// True if along every axis the gap to the other box, rounded to a double, is at most `reach`. Every pair of boxes
    /// whose true gap is at most `reach` is near.
    #[inline]
    #[must_use]
    pub fn is_near(&self, other: &Bounds<D>, reach: f64) -> bool {
        (0..D).all(|axis| (self.low[axis] - other.high[axis] <= reach) & (other.low[axis] - self.high[axis] <= reach))
    }

    /// A box that meets all near boxes: each side moves outward by more than the rounding errors of a near gap and of
    /// the sum. Overflow gives infinity, which is also outward.
    #[must_use]
    pub fn inflated(&self, reach: f64) -> Bounds<D> {
        if reach == 0.0 {
            return *self;
        }
        let by = reach.next_up();
        Bounds { low: self.low.map(|low| (low - by).next_down()), high: self.high.map(|high| (high + by).next_up()) }
    }

    /// The intersection with another box; if it is empty, the side of the other box that is next to this one.
    pub(crate) fn clipped(&self, to: &Bounds<D>) -> Bounds<D> {
        let clip = |x: f64, axis: usize| x.max(to.low[axis]).min(to.high[axis]);
        Bounds {
            low: std::array::from_fn(|axis| clip(self.low[axis], axis)),
            high: std::array::from_fn(|axis| clip(self.high[axis], axis)),
        }
    }

    pub(crate) fn is_finite(&self) -> bool {
        self.low.iter().chain(&self.high).all(|c| c.is_finite())
    }
}
