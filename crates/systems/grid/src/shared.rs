//! The boxes of each of two sets that may meet a box of the other set.
//!
//! If two large meshes cross, nearly all triangles are far from the other mesh. A fine grid over the common box of both
//! sets has one bit for each cell. It rejects most of these triangles in two passes over either set, without a list of
//! each cell's content.
//!
//! # Why nothing is missed
//! Cells are found by monotone steps (`steps.rs`). If two boxes have a common point, the cell of that point is between
//! the steps of either box, clamped or not. So the one box marks the cell, and the other box finds it marked.

use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

use rayon::prelude::*;

use crate::Bounds;
use crate::steps::Steps;

/// The number of boxes that one thread takes at a time.
const PART: usize = 8192;
/// The maximum number of cells along an axis.
const MOST_STEPS: usize = 256;
/// The number of boxes in the sample that determines the number of cells.
const SAMPLE: usize = 4096;
/// The maximum mean number of cells per box.
const MOST_CELLS: u64 = 16;

/// A set of boxes, as a function from index to box.
pub type BoxOf<'a> = &'a (dyn Fn(usize) -> Bounds<3> + Sync);

/// The common box of both sets, and a bit for each of its cells.
struct Marks {
    common: Bounds<3>,
    steps: [Steps; 3],
    bits: Vec<AtomicU64>,
}

/// The indices of the boxes of each set that may meet a box of the other set, ascending, and the bounding box of each
/// set. All boxes that do meet are included, and some that do not.
///
/// # Panics
/// If a set has 2^32 boxes.
#[must_use]
pub fn shared(counts: [usize; 2], box_of: [BoxOf<'_>; 2]) -> ([Vec<u32>; 2], [Bounds<3>; 2]) {
    let all = [0, 1].map(|set: usize| around(counts[set], box_of[set]));
    let Some(common) = common(&all) else { return ([Vec::new(), Vec::new()], all) };
    let mut marks = Marks::new(common, counts, box_of);
    marks.mark((0..counts[1]).into_par_iter().with_min_len(PART), box_of[1]);
    let first = marks.marked(counts[0], box_of[0]);
    marks.clear();
    marks.mark(first.par_iter().with_min_len(PART).map(|&place| place as usize), box_of[0]);
    let second = marks.marked(counts[1], box_of[1]);
    ([first, second], all)
}

fn around(count: usize, box_of: BoxOf<'_>) -> Bounds<3> {
    let of = |part: usize| {
        let places = part * PART..count.min((part + 1) * PART);
        places.fold(Bounds::NOTHING, |all, place| all.union(&box_of(place)))
    };
    (0..count.div_ceil(PART)).into_par_iter().map(of).reduce(|| Bounds::NOTHING, |all, one| all.union(&one))
}

/// The intersection of two boxes, if it is not empty.
fn common([a, b]: &[Bounds<3>; 2]) -> Option<Bounds<3>> {
    let low = [0, 1, 2].map(|axis: usize| a.low[axis].max(b.low[axis]));
    let high = [0, 1, 2].map(|axis: usize| a.high[axis].min(b.high[axis]));
    (0..3).all(|axis| low[axis] <= high[axis]).then_some(Bounds { low, high })
}

impl Marks {
    fn new(common: Bounds<3>, counts: [usize; 2], box_of: [BoxOf<'_>; 2]) -> Marks {
        let extent = [0, 1, 2].map(|axis: usize| (common.high[axis] / 2.0 - common.low[axis] / 2.0).max(0.0));
        let largest = extent.iter().copied().fold(0.0, f64::max);
        let mut across = counts[0].max(counts[1]).isqrt().clamp(1, MOST_STEPS);
        loop {
            let steps = [0, 1, 2].map(|axis: usize| {
                #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)] // about
                let count = if largest > 0.0 { (extent[axis] / largest * across as f64) as usize } else { 1 };
                Steps::new([common.low[axis], common.high[axis]], count.max(1))
            });
            let marks = Marks { common, steps, bits: Vec::new() };
            let is_coarse = (0..2).all(|set| {
                let every = counts[set].div_ceil(SAMPLE).max(1);
                let sample = (0..counts[set]).step_by(every).filter_map(|place| marks.range(&box_of[set](place)));
                let (count, cells) = sample.fold((0, 0), |(count, cells), range| (count + 1, cells + volume(range)));
                cells <= MOST_CELLS * count
            });
            if is_coarse || across == 1 {
                let cells: usize = marks.steps.iter().map(Steps::count).product();
                let bits = std::iter::repeat_with(AtomicU64::default).take(cells.div_ceil(64)).collect();
                return Marks { bits, ..marks };
            }
            across /= 2;
        }
    }

    /// The first and the last steps that a box reaches; `None` if it is outside of the common box.
    #[inline]
    fn range(&self, one: &Bounds<3>) -> Option<[[u32; 3]; 2]> {
        if !self.common.is_near(one, 0.0) {
            return None;
        }
        let steps = |[x, y, z]: [f64; 3]| [self.steps[0].short(x), self.steps[1].short(y), self.steps[2].short(z)];
        Some([steps(one.low), steps(one.high)])
    }

    /// Visits the cells of a range, those along z in words, as a word and its bits; ends when `visit` returns true.
    #[inline]
    fn each(&self, [low, high]: [[u32; 3]; 2], mut visit: impl FnMut(&AtomicU64, u64) -> bool) {
        let [_, ny, nz] = [0, 1, 2].map(|axis: usize| self.steps[axis].count());
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                let row = (x as usize * ny + y as usize) * nz;
                let (mut from, to) = (row + low[2] as usize, row + high[2] as usize + 1);
                while from < to {
                    let next = ((from / 64 + 1) * 64).min(to);
                    let bits = (u64::MAX >> (64 - (next - from))) << (from % 64);
                    if visit(&self.bits[from / 64], bits) {
                        return;
                    }
                    from = next;
                }
            }
        }
    }

    fn mark(&self, places: impl ParallelIterator<Item = usize>, box_of: BoxOf<'_>) {
        places.for_each(|place| {
            let Some(range) = self.range(&box_of(place)) else { return };
            self.each(range, |word, bits| {
                // Most bits are set already; an unnecessary store would take the cache line from other threads.
                if word.load(Relaxed) & bits != bits {
                    word.fetch_or(bits, Relaxed);
                }
                false
            });
        });
    }

    fn marked(&self, count: usize, box_of: BoxOf<'_>) -> Vec<u32> {
        let is_marked = |place: usize| {
            let mut is_marked = false;
            if let Some(range) = self.range(&box_of(place)) {
                self.each(range, |word, bits| {
                    is_marked = word.load(Relaxed) & bits != 0;
                    is_marked
                });
            }
            is_marked
        };
        let part = |part: usize| {
            let places = part * PART..count.min((part + 1) * PART);
            places.filter(|&place| is_marked(place)).map(|place| u32::try_from(place).expect("2^32 boxes")).collect()
        };
        let parts: Vec<Vec<u32>> = (0..count.div_ceil(PART)).into_par_iter().map(part).collect();
        parts.concat()
    }

    fn clear(&mut self) {
        self.bits.iter_mut().for_each(|word| *word.get_mut() = 0);
    }
}

fn volume([low, high]: [[u32; 3]; 2]) -> u64 {
    (0..3).map(|axis| u64::from(high[axis] - low[axis] + 1)).product()
}
