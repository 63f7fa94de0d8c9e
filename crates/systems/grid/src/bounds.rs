//! Axis-parallel boxes, and when two of them are near each other.
//!
//! # Why no near pair is missed
//! Two boxes are near if along every axis the gap between them, as computed,
//! is at most the reach. A difference is rounded monotonically and the reach
//! is a double, so a gap that is truly at most the reach is computed as at most
//! the reach. An overflow makes an infinite gap of one that is larger than every
//! double. With reach zero the rule is exact, as a difference of doubles is
//! rounded to zero only if it is zero: closed boxes that touch are near.

/// A closed box with sides along the axes; a point is one too.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Bounds<const D: usize> {
    /// The lowest coordinate along each axis.
    pub low: [f64; D],
    /// The highest.
    pub high: [f64; D],
}

impl<const D: usize> Bounds<D> {
    /// What holds nothing: every union with it is the other.
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

    /// Whether along every axis the gap to the other box, rounded to a double,
    /// is at most `reach`. All boxes are near that truly are that near.
    #[inline]
    #[must_use]
    pub fn is_near(&self, other: &Bounds<D>, reach: f64) -> bool {
        (0..D).all(|axis| (self.low[axis] - other.high[axis] <= reach) & (other.low[axis] - self.high[axis] <= reach))
    }

    /// A box that meets all that are near: each side moved outward by more than
    /// the rounding of a gap that is near and that of the sum. What overflows is
    /// infinite, which is outward too.
    pub(crate) fn inflated(&self, reach: f64) -> Bounds<D> {
        if reach == 0.0 {
            return *self;
        }
        let by = reach.next_up();
        Bounds { low: self.low.map(|low| (low - by).next_down()), high: self.high.map(|high| (high + by).next_up()) }
    }

    /// The part of the box that lies in another; if there is none, the side of
    /// the other that is next to it.
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
