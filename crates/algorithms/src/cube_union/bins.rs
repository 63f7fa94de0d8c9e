//! Cubes sorted into a uniform grid by their lower corners.
//!
//! A cube is stored once, in the cell of its lower corner, and no cell is
//! smaller than a cube: what reaches a cell is stored there or in one of its
//! seven lower neighbours, which are four runs of the sorted list. So memory is
//! one entry for each cube and one number for each cell, of which there are at
//! most [`PER_CUBE`] for each cube, however far apart the cubes are.
//!
//! The list is sorted in two passes that both read and write in order: into
//! blocks of consecutive cells, each part of the input into its own slice of
//! every block, then each block by cell. Both keep the order of the input
//! among equals, so the result does not depend on the number of threads.

use rayon::prelude::*;

use super::coordinate::Coordinate;

/// Cells per cube, at most (and [`MIN_CELLS`] in any case).
const PER_CUBE: usize = 2;
const MIN_CELLS: usize = 64;
/// Blocks of cells, at most.
const BLOCKS: usize = 1024;
/// Cubes that are sorted into blocks by one task.
const CHUNK: usize = 1 << 18;

/// A cube in the sorted list.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Entry<R> {
    /// The lower corner, from the grid's.
    pub(super) lower: [R; 3],
    /// The place in the input.
    pub(super) index: u32,
}

/// The grid.
pub(super) struct Bins<R> {
    /// The edge of a cell.
    pub(super) cell: u64,
    /// How many cells along each axis.
    pub(super) counts: [usize; 3],
    /// Where the entries of each cell start, x fastest, and where the last one's end.
    starts: Vec<u32>,
    entries: Vec<Entry<R>>,
}

/// Which cell a point is in.
#[derive(Clone, Copy)]
struct Layout {
    cell: u64,
    counts: [usize; 3],
}

impl Layout {
    /// The smallest cells that are not too many, `edge` times a power of two.
    fn new(cubes: usize, extents: [u64; 3], edge: u64) -> Layout {
        let most = MIN_CELLS.max(PER_CUBE.saturating_mul(cubes)) as u128;
        let mut cell = edge;
        loop {
            let counts = extents.map(|extent| u128::from(extent / cell) + 1);
            // Each is at most 2^62 + 1: two of them can't overflow, the third is looked at only then.
            if counts[0] * counts[1] <= most && counts[0] * counts[1] * counts[2] <= most {
                // (at most `most`)
                let counts = counts.map(|count| usize::try_from(count).unwrap_or_else(|_| unreachable!("few cells")));
                return Layout { cell, counts };
            }
            cell *= 2;
        }
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
    /// Sorts the cubes. `extents` is from `least` to the largest upper corner.
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
        // By block, then by chunk; turned into chunks, each with its slice of every block.
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
            // Each start has moved to its end, which is the next one's start.
            starts[..cells].rotate_right(1);
            starts[0] = 0;
            starts[..cells].iter_mut().for_each(|start| *start += first);
        });
        let last = starts.len() - 1;
        // (no more than there are indices)
        starts[last] = u32::try_from(lowers.len()).unwrap_or_else(|_| unreachable!("checked by the caller"));
        Bins { cell: layout.cell, counts: layout.counts, starts, entries }
    }

    /// How many cells there are.
    pub(super) fn cells(&self) -> usize {
        self.starts.len() - 1
    }

    /// The place of a cell along each axis.
    pub(super) fn place(&self, id: usize) -> [usize; 3] {
        let [x, y, _] = self.counts;
        [id % x, id / x % y, id / (x * y)]
    }

    /// Calls `take` with all cubes that reach the cell, some that don't among them.
    #[inline]
    pub(super) fn near(&self, id: usize, [x, y, z]: [usize; 3], mut take: impl FnMut(&Entry<R>)) {
        let row = self.counts[0];
        let layer = row * self.counts[1];
        let left = id - usize::from(x > 0);
        let mut run = |back: usize| {
            let run = self.starts[left - back] as usize..self.starts[id - back + 1] as usize;
            self.entries[run].iter().for_each(&mut take);
        };
        run(0);
        if y > 0 {
            run(row);
        }
        if z > 0 {
            run(layer);
            if y > 0 {
                run(layer + row);
            }
        }
    }
}
