//! The choice of the number of cells.

use rayon::prelude::*;

use super::Frame;
use crate::Bounds;

/// The maximum mean number of coarse entries per box that [`Sizes::of`] chooses.
pub const MOST_ENTRIES: u64 = 8;
/// The approximate number of boxes per coarse cell.
pub const COARSE_BOXES: f64 = 8.0;
/// The maximum number of coarse cells along an axis.
const MOST_STEPS: f64 = 1024.0;

/// The numbers of cells of a grid.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Sizes {
    /// The number of coarse cells along each axis, one or more.
    pub coarse: [u32; 3],
    /// The number of fine cells per coarse cell along each axis, one or more; rounded up to a power of two.
    pub fine: u32,
    /// The number of boxes above which a coarse cell is refined.
    pub full: u32,
}

impl Sizes {
    /// Sizes for these boxes: cells are about cubes, and a coarse cell would hold [`COARSE_BOXES`] if the boxes were
    /// small and spread evenly. The numbers are halved until there are at most [`MOST_ENTRIES`] entries per box.
    #[must_use]
    pub fn of(boxes: &[Bounds<3>]) -> Sizes {
        const REST: Sizes = Sizes { coarse: [1; 3], fine: 4, full: 32 };
        let all = super::bounds(boxes);
        // Halves, which do not overflow; an axis without extent has one cell.
        let extent = [0, 1, 2].map(|axis: usize| (all.high[axis] / 2.0 - all.low[axis] / 2.0).max(0.0));
        let largest = extent.iter().copied().fold(0.0, f64::max);
        if boxes.len() < 2 || largest == 0.0 {
            return REST;
        }
        #[allow(clippy::cast_precision_loss)] // about
        let wanted = boxes.len() as f64 / COARSE_BOXES;
        let relative = extent.map(|extent| (extent / largest).max(1.0 / MOST_STEPS));
        let volume: f64 = relative.iter().product();
        let mut across = (wanted / volume).cbrt().min(MOST_STEPS);
        loop {
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // from 1 to `MOST_STEPS`
            let coarse = relative.map(|relative| (relative * across).clamp(1.0, MOST_STEPS) as u32);
            let sizes = Sizes { coarse, ..REST };
            let frame = Frame::new(&all, Sizes { fine: 1, ..sizes });
            let entries = |one: &Bounds<3>| {
                let [low, high] = frame.range(one);
                let along = |axis: usize| u64::from(high[axis] - low[axis] + 1);
                along(0) * along(1) * along(2)
            };
            let entries: u64 = boxes.par_iter().with_min_len(super::PART).map(entries).sum();
            // One cell has an entry for each box: the loop ends there at the latest.
            if entries <= MOST_ENTRIES * boxes.len() as u64 {
                return sizes;
            }
            across /= 2.0;
        }
    }
}
