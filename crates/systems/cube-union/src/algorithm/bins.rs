//! Cubes sorted into a uniform grid by their lower corners.
//!
//! A cube is stored once, in the cell of its lower corner. So memory is one
//! entry for each cube and one number for each cell, of which there are at most
//! [`PER_CUBE`] for each cube: where cubes are far apart a cell is larger than a
//! cube, where they are dense it is a half, a quarter and so on of one.
//!
//! A cell's neighbours below, one along each axis or as many as a cube is long,
//! hold all that reaches it, in runs of the sorted list. Some of them are so
//! placed that whatever is stored there covers the cell: then a look at where
//! runs start and end tells that it is covered, without a look at any cube.
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
/// Cells that a cube is long, at most. Cells of half an edge are covered by an eighth of the cubes that touch them and
/// cells of a quarter by nearly a half: with smaller ones it would be hardly more, while cubes that all are in few
/// places would be gathered for more cells in vain.
const FINEST: u64 = 4;
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
    counts: [usize; 3],
    /// What reaches a cell is stored so many cells below it, at most.
    reach: usize,
    /// Cubes that are stored from one to so many cells below it along every axis cover a cell.
    covering: usize,
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
    /// The smallest cells that are not too many: `edge` times a power of two, or `edge` halved, rounded up, and so on.
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

    /// Unless there are more cells.
    fn with_cells(cell: u64, extents: [u64; 3], most: usize) -> Option<Layout> {
        let counts = extents.map(|extent| u128::from(extent / cell) + 1);
        // Each is at most 2^62 + 1: two of them can't overflow, the third is looked at only then.
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
        // A cube of cell q spans from q's coordinates to those plus its edge, both ends included. (The quotients are
        // small: cells are halved only while they are no more than the cubes.)
        let [reach, covering] = [(edge - 1) / layout.cell + 1, (edge / layout.cell).max(1) - 1]
            .map(|cells| usize::try_from(cells).unwrap_or_else(|_| unreachable!("few cells")));
        Bins { cell: layout.cell, counts: layout.counts, reach, covering, starts, entries }
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

    /// Whether all that is stored near a cell reaches it.
    pub(super) fn is_tight(&self, edge: u64) -> bool {
        self.cell * self.reach as u64 == edge
    }

    /// Whether the grid knows a cube that covers the cell; if not, there may be one.
    #[inline]
    pub(super) fn is_covered(&self, id: usize, place: [usize; 3]) -> bool {
        if self.covering == 0 || place.contains(&0) {
            return false;
        }
        self.rows(id, place, 1, self.covering).any(|row| row.start < row.end)
    }

    /// Calls `take` with all cubes that reach the cell, and some that don't unless the grid is [tight](Bins::is_tight).
    #[inline]
    pub(super) fn near(&self, id: usize, place: [usize; 3], mut take: impl FnMut(&Entry<R>)) {
        for row in self.rows(id, place, 0, self.reach) {
            self.entries[row].iter().for_each(&mut take);
        }
    }

    /// The entries of the cells from `first` to `last` cells below this one along each axis, row by row. All of the
    /// axes have `first` cells below it.
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
