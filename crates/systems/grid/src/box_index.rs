//! An index of boxes by a nested grid, for finding the boxes near a box.
//!
//! A uniform grid is efficient if boxes are of similar size and evenly spread, and useless if they are not. Two
//! remedies keep it efficient:
//! * Boxes that would reach many cells go to a separate coarser grid. Cells are not smaller than the mean box, so such
//!   boxes are few.
//! * A cell that holds many boxes gets a nested index.
//!
//! # Each pair once
//! Two boxes can share many cells. They are reported in the first cell that they share: the cell where along each axis
//! one of them starts. An entry knows the axes along which its box starts in the cell, and a query knows the same for
//! itself, so the test is one comparison of bits. The rule also holds within nested grids, if a box that started in an
//! earlier cell counts as started before the first nested cell.
//!
//! # Memory
//! A box has at most 4^D entries in a grid, and on average at most about 2^D. A nested grid must pass a cost test, and
//! nesting ends at a fixed depth.

use std::sync::atomic::{AtomicU32, Ordering};

use rayon::prelude::*;

use crate::Bounds;
use crate::steps::Steps;

/// The number of cells above which a box goes to a coarser grid.
const fn most_cells(dimension: usize) -> usize {
    1 << (2 * dimension)
}

/// The number of entries above which a cell may get a nested grid.
const CROWD: usize = 32;

/// The maximum depth of nested grids, both within cells and for larger boxes.
const DEPTH: u32 = 5;

/// The number of boxes below which one thread enters them all.
const ALONE: usize = 1 << 12;

/// An index of boxes in two or three dimensions; a box is identified by its index 0, 1, 2 …
#[derive(Debug)]
pub struct BoxIndex<const D: usize> {
    boxes: Vec<Bounds<D>>,
    all: Bounds<D>,
    grid: Option<Grid<D>>,
}

impl<const D: usize> BoxIndex<D> {
    /// An index of these boxes.
    ///
    /// # Panics
    /// If there are 2^29 boxes or 2^32 entries or more, or a coordinate is not finite.
    #[must_use]
    pub fn new(boxes: Vec<Bounds<D>>) -> BoxIndex<D> {
        const { assert!(D == 2 || D == 3, "a scene has two or three dimensions") };
        let count = u32::try_from(boxes.len()).ok().filter(|count| count >> (u32::BITS - AXES) == 0);
        let count = count.expect("a box index holds fewer than 2^29 boxes");
        let all = hull(boxes.par_iter().map(|bounds| {
            assert!(bounds.is_finite(), "coordinates must be finite");
            *bounds
        }));
        let entries: Vec<Entry> = (0..count).map(Entry::new).collect();
        let grid = (!boxes.is_empty()).then(|| Grid::new(entries, &boxes, &all, &all, DEPTH));
        BoxIndex { boxes, all, grid }
    }

    /// The boxes.
    #[must_use]
    pub fn boxes(&self) -> &[Bounds<D>] {
        &self.boxes
    }

    /// The number of entries in all cells, as a measure of memory.
    #[must_use]
    pub fn entries(&self) -> usize {
        self.grid.as_ref().map_or(0, Grid::count)
    }

    /// Writes the indices of all boxes [near](Bounds::is_near) the query to `found`, in ascending order.
    ///
    /// # Panics
    /// If the reach is negative or NaN.
    pub fn near(&self, query: &Bounds<D>, reach: f64, found: &mut Vec<u32>) {
        assert!(reach >= 0.0, "a reach is a distance");
        found.clear();
        let Some(grid) = self.grid.as_ref().filter(|_| self.all.is_near(query, reach)) else { return };
        let query = Query { exact: *query, inflated: query.inflated(reach), reach };
        grid.near(&query, 0, &self.boxes, found);
        found.sort_unstable();
    }
}

/// A set of axes, one bit each.
type Axes = u32;
const ALL_AXES: Axes = (1 << AXES) - 1;
/// The maximum number of axes.
const AXES: u32 = 3;

struct Query<const D: usize> {
    exact: Bounds<D>,
    inflated: Bounds<D>,
    reach: f64,
}

/// A box in a cell: its index, and the axes along which the cell is the first that it reaches.
#[derive(Clone, Copy, Debug)]
struct Entry(u32);

impl Entry {
    /// The entry of a box in all of space.
    fn new(place: u32) -> Entry {
        Entry(place << AXES | ALL_AXES)
    }

    #[inline]
    fn place(self) -> usize {
        (self.0 >> AXES) as usize
    }

    /// The entry of the same box in a cell that is the first of a part along these axes.
    #[inline]
    fn within(self, first: Axes) -> Entry {
        Entry(self.0 & (first | !ALL_AXES))
    }

    /// True if the cell is the box's first along all these axes.
    #[inline]
    fn starts(self, axes: Axes) -> bool {
        self.0 & axes == axes
    }
}

#[derive(Debug)]
struct Grid<const D: usize> {
    cells: Cells<D>,
    /// The index of each cell's first entry, and at the end the number of entries.
    starts: Vec<u32>,
    /// The entries, cell after cell.
    entries: Vec<Entry>,
    /// The crowded cells with a nested grid, in ascending order.
    nested: Vec<(usize, Grid<D>)>,
    /// The boxes that would reach too many cells here.
    larger: Option<Box<Grid<D>>>,
}

impl<const D: usize> Grid<D> {
    /// A grid over a part of space, for the entries of a cell with that extent.
    fn of_part(given: Vec<Entry>, boxes: &[Bounds<D>], part: &Bounds<D>, depth: u32) -> Grid<D> {
        let extent = hull(given.par_iter().map(|entry| boxes[entry.place()].clipped(part)));
        Grid::new(given, boxes, part, &extent, depth)
    }

    /// A grid over a part of space, for entries with this extent within the part.
    fn new(mut given: Vec<Entry>, boxes: &[Bounds<D>], part: &Bounds<D>, extent: &Bounds<D>, depth: u32) -> Grid<D> {
        let mut cells = Cells::new(extent, given.len(), mean_extents(&given, boxes, part, extent));
        let reach = |cells: &Cells<D>, entry: &Entry| cells.reach(&boxes[entry.place()]);
        let mut larger = Vec::new();
        if depth > 0 {
            let is_large = |entry: &&Entry| reach(&cells, entry) > most_cells(D);
            larger = given.par_iter().filter(is_large).copied().collect();
        }
        if larger.len() < given.len() && depth > 0 {
            given.retain(|entry| larger.is_empty() || reach(&cells, entry) <= most_cells(D));
        } else {
            larger.clear();
            while given.par_iter().map(|entry| reach(&cells, entry)).sum::<usize>() > most_cells(D) * given.len() {
                cells.coarsen();
            }
        }
        let (starts, entries) = enter(&given, boxes, &cells);
        let mut grid = Grid { cells, starts, entries, nested: Vec::new(), larger: None };
        if depth > 0 {
            grid.nest(boxes, depth - 1);
            grid.larger = (!larger.is_empty()).then(|| Box::new(Grid::of_part(larger, boxes, part, depth - 1)));
        }
        grid
    }

    /// Adds nested grids to crowded cells, if they spread the entries.
    fn nest(&mut self, boxes: &[Bounds<D>], depth: u32) {
        let cut = |cell: usize| {
            let entries = self.of(cell);
            if entries.len() <= CROWD {
                return None;
            }
            let nested = Grid::of_part(entries.to_vec(), boxes, &self.cells.bounds(cell), depth);
            nested.is_worth_it(entries.len()).then_some((cell, nested))
        };
        self.nested = (0..self.cells.len()).into_par_iter().filter_map(cut).collect();
    }

    /// True if a point of a random box meets at most half of the entries that it would meet without the grid.
    fn is_worth_it(&self, without: usize) -> bool {
        let larger = self.larger.as_ref().map_or(0, |larger| larger.entries.len());
        let squares: usize = self.starts.windows(2).map(|w| ((w[1] - w[0]) as usize).pow(2)).sum();
        (larger * without).saturating_add(squares) <= without * without / 2
    }

    fn of(&self, cell: usize) -> &[Entry] {
        &self.entries[self.starts[cell] as usize..self.starts[cell + 1] as usize]
    }

    fn count(&self) -> usize {
        let nested: usize = self.nested.iter().map(|(_, grid)| grid.count()).sum();
        self.entries.len() + nested + self.larger.as_ref().map_or(0, |larger| larger.count())
    }

    /// Visits the cells that the query reaches. Along the axes `before`, the query has started before the first of
    /// them.
    fn near(&self, query: &Query<D>, before: Axes, boxes: &[Bounds<D>], found: &mut Vec<u32>) {
        let [first, last] = self.cells.range(&query.inflated);
        each_place([first, last], |place| {
            let started = (0..D).fold(before, |axes, axis| axes | Axes::from(place[axis] > first[axis]) << axis);
            let cell = self.cells.cell(place);
            let entries = self.of(cell);
            if entries.len() > CROWD
                && let Ok(at) = self.nested.binary_search_by_key(&cell, |&(cell, _)| cell)
            {
                return self.nested[at].1.near(query, started, boxes, found);
            }
            for entry in entries {
                if entry.starts(started) && boxes[entry.place()].is_near(&query.exact, query.reach) {
                    found.push(entry.0 >> AXES);
                }
            }
        });
        if let Some(larger) = &self.larger {
            larger.near(query, before, boxes, found);
        }
    }
}

/// Counting sort by cells. Threads share the counters, so entries of one cell can come in any order; the result does
/// not depend on it.
fn enter<const D: usize>(given: &[Entry], boxes: &[Bounds<D>], cells: &Cells<D>) -> (Vec<u32>, Vec<Entry>) {
    // A single thread does not need atomic operations.
    let is_alone = given.len() < ALONE || rayon::current_num_threads() == 1;
    let each = |visit: &(dyn Fn(&Entry) + Sync)| {
        if is_alone {
            given.iter().for_each(visit);
        } else {
            given.par_iter().with_min_len(ALONE).for_each(visit);
        }
    };
    let counters: Vec<AtomicU32> = (0..=cells.len()).map(|_| AtomicU32::new(0)).collect();
    each(&|entry| {
        each_place(cells.range(&boxes[entry.place()]), |place| {
            let counter = &counters[cells.cell(place)];
            if is_alone {
                counter.store(counter.load(Ordering::Relaxed) + 1, Ordering::Relaxed);
            } else {
                counter.fetch_add(1, Ordering::Relaxed);
            }
        });
    });
    // from counts to ends; filled from the last entry back, they become starts
    let mut end = 0_u32;
    for counter in &counters {
        end = end.checked_add(counter.load(Ordering::Relaxed)).expect("a box index has fewer than 2^32 entries");
        counter.store(end, Ordering::Relaxed);
    }
    let entries: Vec<AtomicU32> = (0..end).map(|_| AtomicU32::new(0)).collect();
    each(&|entry| {
        let range = cells.range(&boxes[entry.place()]);
        each_place(range, |place| {
            let here = (0..D).fold(0, |axes, axis| axes | Axes::from(place[axis] == range[0][axis]) << axis);
            let counter = &counters[cells.cell(place)];
            let at = if is_alone {
                let at = counter.load(Ordering::Relaxed) - 1;
                counter.store(at, Ordering::Relaxed);
                at
            } else {
                counter.fetch_sub(1, Ordering::Relaxed) - 1
            };
            entries[at as usize].store(entry.within(here).0, Ordering::Relaxed);
        });
    });
    let starts = counters.into_iter().map(AtomicU32::into_inner).collect();
    (starts, entries.into_iter().map(|entry| Entry(entry.into_inner())).collect())
}

fn hull<const D: usize>(boxes: impl IndexedParallelIterator<Item = Bounds<D>>) -> Bounds<D> {
    boxes.with_min_len(ALONE).reduce(|| Bounds::NOTHING, |a, b| a.union(&b))
}

/// The mean extent of the boxes along each axis, as a fraction of the whole extent; 1 if the whole extent is 0. Sums
/// use chunks of a fixed size, so they do not depend on the number of threads.
#[allow(clippy::cast_precision_loss)] // a size to aim at
fn mean_extents<const D: usize>(
    given: &[Entry],
    boxes: &[Bounds<D>],
    part: &Bounds<D>,
    extent: &Bounds<D>,
) -> [f64; D] {
    let half = |bounds: &Bounds<D>, axis: usize| bounds.high[axis] / 2.0 - bounds.low[axis] / 2.0;
    let sum = |entries: &[Entry]| {
        let clipped = entries.iter().map(|entry| boxes[entry.place()].clipped(part));
        clipped.fold([0.0; D], |sum, bounds| {
            // the minimum of NaN and 1 is 1
            std::array::from_fn(|axis| sum[axis] + (half(&bounds, axis) / half(extent, axis)).min(1.0))
        })
    };
    let sums: Vec<[f64; D]> = given.par_chunks(ALONE).map(sum).collect();
    std::array::from_fn(|axis| sums.iter().map(|sum| sum[axis]).sum::<f64>() / given.len() as f64)
}

/// Visits all index tuples from the first to the last.
#[inline]
fn each_place<const D: usize>([first, last]: [[usize; D]; 2], mut visit: impl FnMut([usize; D])) {
    let mut place = first;
    loop {
        visit(place);
        let Some(axis) = (0..D).find(|&axis| place[axis] < last[axis]) else { return };
        place[axis] += 1;
        place[..axis].copy_from_slice(&first[..axis]);
    }
}

/// The geometry of a grid's cells.
#[derive(Clone, Copy, Debug)]
struct Cells<const D: usize> {
    steps: [Steps; D],
}

impl<const D: usize> Cells<D> {
    /// About as many cells as boxes, each at least as large as the mean box.
    #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a size to aim at
    fn new(extent: &Bounds<D>, boxes: usize, mean: [f64; D]) -> Cells<D> {
        let mut axes: [usize; D] = std::array::from_fn(|axis| axis);
        axes.sort_by(|&a, &b| mean[b].total_cmp(&mean[a]));
        let mut counts = [1; D];
        let mut cells = boxes.max(1) as f64;
        for (done, &axis) in axes.iter().enumerate() {
            let most = cells.powf(1.0 / (D - done) as f64);
            counts[axis] = ((1.0 / mean[axis]).min(most) as usize).max(1);
            cells /= counts[axis] as f64;
        }
        let steps = |axis: usize| Steps::new([extent.low[axis], extent.high[axis]], counts[axis]);
        Cells { steps: std::array::from_fn(steps) }
    }

    fn len(&self) -> usize {
        self.steps.iter().map(Steps::count).product()
    }

    /// Halves the number of steps along the axis with the most steps.
    fn coarsen(&mut self) {
        let most = self.steps.iter_mut().max_by_key(|steps| steps.count()).expect("there are axes");
        *most = most.coarser();
    }

    #[inline]
    fn cell(&self, place: [usize; D]) -> usize {
        (0..D).rev().fold(0, |cell, axis| cell * self.steps[axis].count() + place[axis])
    }

    /// The first and the last step along each axis that a box reaches.
    #[inline]
    fn range(&self, bounds: &Bounds<D>) -> [[usize; D]; 2] {
        [bounds.low, bounds.high].map(|corner| std::array::from_fn(|axis| self.steps[axis].of(corner[axis])))
    }

    /// The number of cells that a box reaches.
    fn reach(&self, bounds: &Bounds<D>) -> usize {
        let [first, last] = self.range(bounds);
        (0..D).map(|axis| last[axis] - first[axis] + 1).fold(1, usize::saturating_mul)
    }

    /// The approximate bounds of a cell.
    fn bounds(&self, mut cell: usize) -> Bounds<D> {
        let sides: [[f64; 2]; D] = std::array::from_fn(|axis| {
            let place = cell % self.steps[axis].count();
            cell /= self.steps[axis].count();
            self.steps[axis].about(place)
        });
        Bounds { low: sides.map(|[low, _]| low), high: sides.map(|[_, high]| high) }
    }
}
