//! The test whether a query may meet a box.
//!
//! The test uses raw coordinates only. A box is left out if a comparison of doubles shows that it is beside the query,
//! or if its projection is beside the projected line by more than the rounding error of the test. So a triangle that
//! the query meets is never left out, also under a perturbation by infinitesimals.

use predicament_grid::Bounds;

use crate::answer::Extent;

/// A query in raw coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beam {
    pub(super) from: [f64; 3],
    pub(super) to: [f64; 3],
    pub(super) extent: Extent,
}

impl Beam {
    /// True unless the box is certainly beside the query.
    pub(super) fn may_meet(&self, bounds: &Bounds<3>) -> bool {
        (0..3).all(|axis| self.may_meet_slab(bounds.low[axis], bounds.high[axis], axis))
            && [[0, 1], [1, 2], [2, 0]].into_iter().all(|axes| self.may_meet_shadow(bounds, axes))
    }

    /// Compares doubles along one axis, which is exact.
    fn may_meet_slab(&self, low: f64, high: f64, axis: usize) -> bool {
        let (p, q) = (self.from[axis], self.to[axis]);
        let [first, last] = match self.extent {
            _ if p == q => [p, p],
            Extent::Line => return true,
            Extent::Ray if p < q => [p, f64::INFINITY],
            Extent::Ray => [f64::NEG_INFINITY, p],
            Extent::Segment => [p.min(q), p.max(q)],
        };
        low <= last && first <= high
    }

    /// True unless all corners of the projected box are on one side of the projected line. Each corner's determinant
    /// has an error of less than eight units in the last place of the sum of its terms, and one more for underflow.
    fn may_meet_shadow(&self, bounds: &Bounds<3>, [i, j]: [usize; 2]) -> bool {
        const ERROR: f64 = 16.0 * f64::EPSILON;
        let along = [self.to[i] - self.from[i], self.to[j] - self.from[j]];
        let side = |x: f64, y: f64| {
            let terms = [along[0] * (y - self.from[j]), along[1] * (x - self.from[i])];
            let error = ERROR * (terms[0].abs() + terms[1].abs()) + f64::MIN_POSITIVE;
            let determinant = terms[0] - terms[1];
            // A NaN, or an infinite error, decides nothing.
            i8::from(determinant > error) - i8::from(determinant < -error)
        };
        let sides = [bounds.low[i], bounds.high[i]].map(|x| [bounds.low[j], bounds.high[j]].map(|y| side(x, y)));
        let sides = sides.as_flattened();
        !(sides.iter().all(|&side| side > 0) || sides.iter().all(|&side| side < 0))
    }
}
