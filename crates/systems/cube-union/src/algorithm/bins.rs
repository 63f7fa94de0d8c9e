//! Cubes sorted into a uniform grid by their lower corners.
//!
//! A cube is stored once, in the cell of its lower corner. So the memory is one entry for each cube and one number for
//! each cell, and there are at most [`PER_CUBE`] cells for each cube. If cubes are far apart, a cell is larger than a
//! cube; if they are dense, it is a half, a quarter and so on of a cube.
//!
//! All cubes that reach a cell are stored in the cell or in neighbours below it, up to a cube's length along each axis,
//! in runs of the sorted list. For some of these neighbours, every cube that is stored there covers the cell. Then the
//! starts and ends of runs show that the cell is covered, without a look at any cube.
//!
//! The list is sorted in two passes that both read and write in order. The first pass sorts into blocks of consecutive
//! cells; each part of the input has its own slice of every block. The second pass sorts each block by cell. Both
//! passes keep the order of the input among equals, so the result does not depend on the number of threads.

use rayon::prelude::*;

use super::coordinate::Coordinate;

/// The maximum number of cells per cube (but at least [`MIN_CELLS`] cells are allowed).
const PER_CUBE: usize = 2;
const MIN_CELLS: usize = 64;
/// The maximum number of cells per edge of a cube. An eighth of the cubes that touch a cell of half an edge cover it,
/// and nearly a half for cells of a quarter. With smaller cells the share would hardly grow. If all cubes are in few
/// places, smaller cells would only gather them more often.
const FINEST: u64 = 4;
/// The maximum number of blocks of cells.
const BLOCKS: usize = 1024;
/// The number of cubes that one task sorts into blocks.
const CHUNK: usize = 1 << 18;

/// A cube in the sorted list.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Entry<R> {
    /// The lower corner, relative to the grid's.
    pub(super) lower: [R; 3],
    /// The index in the input.
    pub(super) index: u32,
}

/// The grid of sorted cubes.
pub(super) struct Bins<R> {
    /// The edge of a cell.
    pub(super) cell: u64,
    /// The number of cells along each axis.
    counts: [usize; 3],
    /// The maximum distance in cells from a cell down to a cube that reaches it.
    reach: usize,
    /// The maximum distance in cells from a cell down to a cube that covers it: cubes that are 1 to `covering` cells
    /// below along every axis do.
    covering: usize,
    /// The start of each cell's entries, x fastest, and the end of the last cell's entries.
    starts: Vec<u32>,
    entries: Vec<Entry<R>>,
}

/// The map from points to cells.
#[derive(Clone, Copy)]
struct Layout {
    cell: u64,
    counts: [usize; 3],
}

impl Layout {
    /// The layout with the smallest allowed cells: `edge` times a power of two, or `edge` halved, rounded up, and so
    /// on.
    fn new(cubes: usize, extents: [u64; 3], edge: u64) -> Layout {
        let most = PER_CUBE.saturating_mul(cubes);
        let mut cell = edge;
        let mut layout = loop {
            if let Some(layout) = Layout::with_cells(cell, extents, most.max(MIN_CELLS)) {
                break layout;
            }
            cell *= 2;
        };
        while layout.cell <= edge && layout.cell > edge.div_ceil(FINEST) {
            match Layout::with_cells(layout.cell.div_ceil(2), extents, most) {
                Some(finer) => layout = finer,
                None => break,
            }
        }
        layout
    }

    /// The layout with cells of this size; `None` if there are more than `most` cells.
    fn with_cells(cell: u64, extents: [u64; 3], most: usize) -> Option<Layout> {
        let counts = extents.map(|extent| u128::from(extent / cell) + 1);
        // Each count is at most 2^62 + 1: two of them can't overflow, and the third is used only if their product is
        // small.
        let is_few = |count: u128| count <= most as u128;
        if !is_few(counts[0] * counts[1]) || !is_few(counts[0] * counts[1] * counts[2]) {
            return None;
        }
        // (at most `most`)
        let counts = counts.map(|count| usize::try_from(count).unwrap_or_else(|_| unreachable!("few cells")));
        Some(Layout { cell, counts })
    }

    fn cells(self) -> usize {
        self.counts.iter().product()
    }

    #[inline]
    fn id<R: Copy + Into<u64>>(self, lower: [R; 3]) -> usize {
        #[allow(clippy::cast_possible_truncation)] // below the counts
        let [x, y, z] = lower.map(|c| (c.into() / self.cell) as usize);
        (z * self.counts[1] + y) * self.counts[0] + x
    }
}

/// Cuts the list into pieces of these lengths.
fn cut<T>(mut list: &mut [T], lengths: impl Iterator<Item = usize>) -> Vec<&mut [T]> {
    lengths
        .map(|length| {
            let (piece, rest) = std::mem::take(&mut list).split_at_mut(length);
            list = rest;
            piece
        })
        .collect()
}

impl<R: Copy + Default + Into<u64> + Send + Sync> Bins<R> {
    /// Sorts the cubes. `extents` is the distance from `least` to the largest upper corner.
    pub(super) fn new<C: Coordinate<Offset = R>>(
        lowers: &[[C; 3]],
        least: [C; 3],
        extents: [u64; 3],
        edge: u64,
    ) -> Bins<R> {
        let layout = Layout::new(lowers.len(), extents, edge);
        let shift = (layout.cells().div_ceil(BLOCKS)).next_power_of_two().trailing_zeros();
        let blocks = layout.cells().div_ceil(1 << shift);
        let offset = |lower: &[C; 3]| [0, 1, 2].map(|axis| lower[axis].offset(least[axis]));

        let per_chunk: Vec<Vec<u32>> = lowers
            .par_chunks(CHUNK)
            .map(|chunk| {
                let mut sizes = vec![0; blocks];
                chunk.iter().for_each(|lower| sizes[layout.id(offset(lower)) >> shift] += 1);
                sizes
            })
            .collect();
        let mut entries = vec![Entry::default(); lowers.len()];
        let chunks = per_chunk.len();
        let lengths = (0..blocks * chunks).map(|at| per_chunk[at % chunks][at / chunks] as usize);
        // By block, then by chunk; transposed to chunks, each with its slice of every block.
        let mut slices: Vec<Vec<&mut [Entry<R>]>> = (0..chunks).map(|_| Vec::with_capacity(blocks)).collect();
        for (at, slice) in cut(&mut entries, lengths).into_iter().enumerate() {
            slices[at % chunks].push(slice);
        }
        let indices = (0_u32..).step_by(CHUNK).take(chunks);
        let tasks: Vec<_> = lowers.chunks(CHUNK).zip(slices).zip(indices).collect();
        tasks.into_par_iter().for_each(|((chunk, mut slices), first)| {
            let mut filled = vec![0_usize; blocks];
            for (index, lower) in (first..).zip(chunk) {
                let lower = offset(lower);
                let block = layout.id(lower) >> shift;
                slices[block][filled[block]] = Entry { lower, index };
                filled[block] += 1;
            }
        });

        let mut starts = vec![0_u32; layout.cells() + 1];
        let sizes = (0..blocks).map(|block| per_chunk.iter().map(|sizes| sizes[block] as usize).sum());
        let mut first = 0_u32;
        let blocks: Vec<_> = cut(&mut entries, sizes)
            .into_iter()
            .zip(starts.chunks_mut(1 << shift))
            .map(|(entries, starts)| {
                let block = (first, entries, starts);
                // (no more than there are indices)
                first += u32::try_from(block.1.len()).unwrap_or_else(|_| unreachable!("checked by the caller"));
                block
            })
            .collect();
        blocks.into_par_iter().enumerate().for_each_init(Vec::new, |copy, (block, (first, entries, starts))| {
            let within = |entry: &Entry<R>| layout.id(entry.lower) - (block << shift);
            let cells = starts.len().min(layout.cells() - (block << shift));
            entries.iter().for_each(|entry| starts[within(entry)] += 1);
            let mut sum = 0;
            for start in &mut starts[..cells] {
                sum += std::mem::replace(start, sum);
            }
            copy.clear();
            copy.extend_from_slice(entries);
            for entry in copy.iter() {
                let start = &mut starts[within(entry)];
                entries[*start as usize] = *entry;
                *start += 1;
            }
            // Each start has moved to its end, which is the start of the next cell.
            starts[..cells].rotate_right(1);
            starts[0] = 0;
            starts[..cells].iter_mut().for_each(|start| *start += first);
        });
        let last = starts.len() - 1;
        // (no more than there are indices)
        starts[last] = u32::try_from(lowers.len()).unwrap_or_else(|_| unreachable!("checked by the caller"));
        // A cube of cell q spans from q's coordinates to those plus its edge, both ends included. (The quotients are
        // small: cells are halved only while there are at most as many cells per edge as cubes.)
        let [reach, covering] = [(edge - 1) / layout.cell + 1, (edge / layout.cell).max(1) - 1]
            .map(|cells| usize::try_from(cells).unwrap_or_else(|_| unreachable!("few cells")));
        Bins { cell: layout.cell, counts: layout.counts, reach, covering, starts, entries }
    }

    /// The number of cells.
    pub(super) fn cells(&self) -> usize {
        self.starts.len() - 1
    }

    /// The index of a cell along each axis.
    pub(super) fn place(&self, id: usize) -> [usize; 3] {
        let [x, y, _] = self.counts;
        [id % x, id / x % y, id / (x * y)]
    }

    /// True if every cube that [`near`](Bins::near) finds reaches the cell.
    pub(super) fn is_tight(&self, edge: u64) -> bool {
        self.cell * self.reach as u64 == edge
    }

    /// True if the grid finds a cube that covers the cell; a covering cube may exist even if not.
    #[inline]
    pub(super) fn is_covered(&self, id: usize, place: [usize; 3]) -> bool {
        if self.covering == 0 || place.contains(&0) {
            return false;
        }
        self.rows(id, place, 1, self.covering).any(|row| row.start < row.end)
    }

    /// Calls `take` with all cubes that reach the cell. Unless the grid is [tight](Bins::is_tight), it also gets some
    /// other cubes.
    #[inline]
    pub(super) fn near(&self, id: usize, place: [usize; 3], mut take: impl FnMut(&Entry<R>)) {
        for row in self.rows(id, place, 0, self.reach) {
            self.entries[row].iter().for_each(&mut take);
        }
    }

    /// The entries of the cells from `first` to `last` cells below this one along each axis, row by row. There must be
    /// at least `first` cells below it along each axis.
    #[inline]
    fn rows(
        &self,
        id: usize,
        place: [usize; 3],
        first: usize,
        last: usize,
    ) -> impl Iterator<Item = std::ops::Range<usize>> + '_ {
        let row = self.counts[0];
        let layer = row * self.counts[1];
        let [x, y, z] = place.map(|at| at.min(last));
        (first..=z).flat_map(move |z| {
            (first..=y).map(move |y| {
                let end = id - z * layer - y * row - first;
                self.starts[end + first - x] as usize..self.starts[end + 1] as usize
            })
        })
    }
}
