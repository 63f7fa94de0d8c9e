//! Building a grid: counting, prefix sums, filling.

use std::sync::atomic::{AtomicU32, Ordering};

use rayon::prelude::*;

use super::{Frame, PART, Sizes, TwoLevel, bounds, number};
use crate::Bounds;

/// The number of slots below which lists are sorted on one thread.
const SORTED: usize = 4096;

fn zeros(count: usize) -> Vec<AtomicU32> {
    std::iter::repeat_with(|| AtomicU32::new(0)).take(count).collect()
}

/// The prefix sums of counts, and their total.
fn sums(counts: impl ExactSizeIterator<Item = u32>) -> Vec<u32> {
    let mut sums = Vec::with_capacity(counts.len() + 1);
    let mut sum = 0_u32;
    sums.push(0);
    for count in counts {
        sum = sum.checked_add(count).expect("fewer than 2^32 cells and entries");
        sums.push(sum);
    }
    sums
}

pub(super) fn build(boxes: &[Bounds<3>], sizes: Sizes) -> TwoLevel {
    let frame = Frame::new(&bounds(boxes), sizes);
    let counts = zeros(frame.count());
    boxes.par_iter().with_min_len(PART).for_each(|one| {
        each_coarse(&frame, one, |cell, _| {
            counts[cell].fetch_add(1, Ordering::Relaxed);
        });
    });
    let fine = frame.fine().iter().try_fold(1_u32, |product, &fine| product.checked_mul(fine));
    let fine = fine.expect("a coarse cell has fewer than 2^32 fine ones");
    let of_cell = |count: AtomicU32| if count.into_inner() > sizes.full { fine } else { 1 };
    let slots = sums(counts.into_iter().map(of_cell));
    let mut grid = TwoLevel { frame, slots, starts: Vec::new(), entries: Vec::new() };
    let last = grid.slots[grid.slots.len() - 1];
    let counts = zeros(last as usize);
    boxes.par_iter().with_min_len(PART).for_each(|one| {
        each_slot(&grid, one, |slot| {
            counts[slot].fetch_add(1, Ordering::Relaxed);
        });
    });
    // The lists are filled from the last entry back, so ends become starts.
    let starts = sums(counts.iter().map(|count| count.load(Ordering::Relaxed)));
    let ends = counts;
    ends.par_iter().zip(&starts[1..]).for_each(|(end, &to)| end.store(to, Ordering::Relaxed));
    let entries = zeros(starts[starts.len() - 1] as usize);
    boxes.par_iter().enumerate().with_min_len(PART).for_each(|(at, one)| {
        let at = number(at);
        each_slot(&grid, one, |slot| {
            let place = ends[slot].fetch_sub(1, Ordering::Relaxed) - 1;
            entries[place as usize].store(at, Ordering::Relaxed);
        });
    });
    grid.entries = entries.into_par_iter().map(AtomicU32::into_inner).collect();
    sort(&starts, &mut grid.entries);
    grid.starts = starts;
    grid
}

/// A value for each axis. (Closures over arrays are not always inlined.)
#[inline(always)]
fn three(of: impl Fn(usize) -> u32) -> [u32; 3] {
    [of(0), of(1), of(2)]
}

/// Visits the coarse cells of a box, each with its steps along the axes.
fn each_coarse(frame: &Frame, one: &Bounds<3>, mut then: impl FnMut(usize, [u32; 3])) {
    let [low, high] = frame.range(one);
    let [low, high] = [frame.coarse_of(low), frame.coarse_of(high)];
    for x in low[0]..=high[0] {
        for y in low[1]..=high[1] {
            for z in low[2]..=high[2] {
                then(frame.cell([x, y, z]), [x, y, z]);
            }
        }
    }
}

/// Visits the slots of a box.
pub(super) fn each_slot(grid: &TwoLevel, one: &Bounds<3>, mut then: impl FnMut(usize)) {
    let frame = &grid.frame;
    let [low, high] = frame.range(one);
    each_coarse(frame, one, |cell, at| {
        let first = grid.slots[cell];
        if !grid.is_refined(cell) {
            then(first as usize);
            return;
        }
        // The part of the box's steps that is in this cell.
        let origin = three(|axis| at[axis] << frame.shift[axis]);
        let from = three(|axis| low[axis].max(origin[axis]) - origin[axis]);
        let to = three(|axis| (high[axis] - origin[axis]).min((1 << frame.shift[axis]) - 1));
        for x in from[0]..=to[0] {
            for y in from[1]..=to[1] {
                for z in from[2]..=to[2] {
                    then((first + frame.place([x, y, z])) as usize);
                }
            }
        }
    });
}

/// Sorts the entries of each slot. `starts` are those of these slots; the first is the index where `entries` begin.
fn sort(starts: &[u32], entries: &mut [u32]) {
    let slots = starts.len() - 1;
    if slots <= SORTED {
        let first = starts[0];
        for pair in starts.windows(2).filter(|pair| pair[1] - pair[0] > 1) {
            entries[(pair[0] - first) as usize..(pair[1] - first) as usize].sort_unstable();
        }
        return;
    }
    let middle = slots / 2;
    let (left, right) = entries.split_at_mut((starts[middle] - starts[0]) as usize);
    rayon::join(|| sort(&starts[..=middle], left), || sort(&starts[middle..], right));
}
