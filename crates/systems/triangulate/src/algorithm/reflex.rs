//! A grid of the corners that are not convex, to find those in an ear.
//!
//! The grid's coordinates are the ranks of the sweep along each axis. It has as many cells as corners, and it serves
//! constructed vertices as well.

/// Corners in cells, by their ranks along both axes.
pub(super) struct Reflex {
    side: u64,
    /// An upper bound on the ranks along each axis.
    ranks: u64,
    /// The first index and the number of the entries of each cell.
    cells: Vec<[u32; 2]>,
    entries: Vec<u32>,
}

impl Reflex {
    /// Builds the grid of corners, each with its ranks along both axes.
    pub fn new(corners: &[(u32, [u32; 2])]) -> Reflex {
        let side = (corners.len() as u64).isqrt().max(1);
        let ranks = 1 + corners.iter().flat_map(|(_, ranks)| ranks).copied().max().map_or(0, u64::from);
        let mut grid = Reflex { side, ranks, cells: Vec::new(), entries: vec![0; corners.len()] };
        grid.cells = vec![[0; 2]; grid.cell([side - 1; 2]) + 1];
        let places: Vec<usize> =
            corners.iter().map(|&(_, ranks)| grid.cell(ranks.map(|rank| grid.step(rank)))).collect();
        places.iter().for_each(|&cell| grid.cells[cell][1] += 1);
        let mut start = 0;
        for [first, count] in &mut grid.cells {
            *first = start;
            start += std::mem::take(count);
        }
        for (&cell, &(corner, _)) in places.iter().zip(corners) {
            let [first, count] = &mut grid.cells[cell];
            grid.entries[(*first + *count) as usize] = corner;
            *count += 1;
        }
        grid
    }

    fn step(&self, rank: u32) -> u64 {
        (u64::from(rank) * self.side / self.ranks).min(self.side - 1)
    }

    fn cell(&self, [x, y]: [u64; 2]) -> usize {
        usize::try_from(y * self.side + x).unwrap_or(usize::MAX)
    }

    /// The first corner with ranks in these ranges for which `blocks` returns true. A corner for which it returns
    /// `None` is removed: it is convex by now.
    pub fn find(&mut self, ranges: [[u32; 2]; 2], mut blocks: impl FnMut(u32) -> Option<bool>) -> Option<u32> {
        let [[left, right], [bottom, top]] = ranges.map(|range| range.map(|rank| self.step(rank)));
        for y in bottom..=top {
            for x in left..=right {
                let cell = self.cell([x, y]);
                let [first, mut count] = self.cells[cell];
                let mut at = 0;
                while at < count {
                    let place = (first + at) as usize;
                    match blocks(self.entries[place]) {
                        Some(true) => {
                            self.cells[cell][1] = count;
                            return Some(self.entries[place]);
                        }
                        Some(false) => at += 1,
                        None => {
                            count -= 1;
                            self.entries[place] = self.entries[(first + count) as usize];
                        }
                    }
                }
                self.cells[cell][1] = count;
            }
        }
        None
    }
}
