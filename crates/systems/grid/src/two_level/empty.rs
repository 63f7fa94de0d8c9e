//! Connected regions of empty cells.

use rayon::prelude::*;

use super::{NONE, Slot, TwoLevel};

/// The regions of empty cells, numbered by their first slots.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct EmptyRegions {
    /// The region of each slot.
    region: Vec<u32>,
    /// The first slot of each region.
    first: Vec<Slot>,
    /// For each region, true if one of its cells is at the border of the grid.
    is_open: Vec<bool>,
}

impl EmptyRegions {
    /// The region of an empty cell; `None` if the cell is not empty.
    #[must_use]
    pub fn of(&self, slot: Slot) -> Option<usize> {
        self.of_index(slot.index())
    }

    /// The region of the cell with this index, like [`EmptyRegions::of`].
    #[must_use]
    pub fn of_index(&self, slot: usize) -> Option<usize> {
        let region = self.region[slot];
        (region != NONE).then_some(region as usize)
    }

    /// The number of regions.
    #[must_use]
    pub fn len(&self) -> usize {
        self.first.len()
    }

    /// True if there are no regions.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.first.is_empty()
    }

    /// The first cell of each region.
    #[must_use]
    pub fn first(&self) -> &[Slot] {
        &self.first
    }

    /// True if a region continues outside of the grid. The space outside of all boxes belongs to such regions.
    #[must_use]
    pub fn is_open(&self, region: usize) -> bool {
        self.is_open[region]
    }

    /// The memory of the regions in bytes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of::<u32>() * (self.region.len() + self.first.len()) + self.is_open.len()
    }
}

/// The number of layers of coarse cells that one thread joins at a time.
const LAYERS: u32 = 8;

/// A part of a union-find forest: each slot's parent, which is never a later slot.
struct Forest<'a> {
    /// The first slot of this part.
    first: u32,
    parent: &'a mut [u32],
}

impl Forest<'_> {
    /// The lowest slot of a class.
    fn root(&mut self, mut slot: u32) -> u32 {
        let at = |slot: u32| (slot - self.first) as usize;
        while self.parent[at(slot)] != slot {
            self.parent[at(slot)] = self.parent[at(self.parent[at(slot)])];
            slot = self.parent[at(slot)];
        }
        slot
    }

    /// Unites the classes of two slots, if both slots are empty.
    fn join(&mut self, grid: &TwoLevel, a: u32, b: u32) {
        if grid.is_empty(a) && grid.is_empty(b) {
            let [a, b] = [self.root(a), self.root(b)];
            self.parent[(a.max(b) - self.first) as usize] = a.min(b);
        }
    }
}

impl TwoLevel {
    fn is_empty(&self, slot: u32) -> bool {
        self.starts[slot as usize] == self.starts[slot as usize + 1]
    }
}

/// Finds the regions by union-find, first in separate slabs; cells with a common face are neighbours.
///
/// A cell is the set of points that the monotone maps send to it. Each point of the common face of two neighbours is in
/// one of them, so the way from one to the other does not leave them.
pub(super) fn regions(grid: &TwoLevel) -> EmptyRegions {
    let frame = &grid.frame;
    let [nx, ny, nz] = frame.coarse;
    let mut parent: Vec<u32> = (0..super::number(grid.slots())).collect();
    let first_slot = |x: u32| grid.slots[x as usize * ny as usize * nz as usize];
    let mut slabs = Vec::new();
    let mut rest = &mut parent[..];
    for x in (0..nx).step_by(LAYERS as usize) {
        let end = (x + LAYERS).min(nx);
        let (part, others) = rest.split_at_mut((first_slot(end) - first_slot(x)) as usize);
        slabs.push((x..end, Forest { first: first_slot(x), parent: part }));
        rest = others;
    }
    slabs.into_par_iter().for_each(|(layers, mut forest)| {
        for x in layers.clone() {
            for y in 0..ny {
                for z in 0..nz {
                    let cell = frame.cell([x, y, z]);
                    if grid.is_refined(cell) {
                        within(grid, cell, &mut forest);
                    }
                    let after = [[x + 1, y, z], [x, y + 1, z], [x, y, z + 1]];
                    for (axis, next) in after.into_iter().enumerate() {
                        if next[axis] < frame.coarse[axis] && next[0] < layers.end {
                            across(grid, [cell, frame.cell(next)], axis, &mut forest);
                        }
                    }
                }
            }
        }
    });
    let mut forest = Forest { first: 0, parent: &mut parent };
    for x in (LAYERS..nx).step_by(LAYERS as usize) {
        for y in 0..ny {
            for z in 0..nz {
                across(grid, [[x - 1, y, z], [x, y, z]].map(|at| frame.cell(at)), 0, &mut forest);
            }
        }
    }
    let mut regions = EmptyRegions { region: parent, first: Vec::new(), is_open: Vec::new() };
    for slot in 0..super::number(grid.slots()) {
        // A region begins with its lowest slot, and a parent is never later.
        let above = regions.region[slot as usize];
        regions.region[slot as usize] = if !grid.is_empty(slot) {
            NONE
        } else if above == slot {
            regions.first.push(Slot(slot));
            super::number(regions.first.len() - 1)
        } else {
            regions.region[above as usize]
        };
    }
    regions.is_open = vec![false; regions.first.len()];
    let last = [0, 1, 2].map(|axis: usize| super::number(frame.steps[axis].count()) - 1);
    for cell in (0..frame.count()).filter(|&cell| frame.is_at_border(cell)) {
        for slot in (grid.slots[cell]..grid.slots[cell + 1]).map(Slot) {
            let Some(region) = regions.of(slot) else { continue };
            let steps = frame.steps_of(cell, grid.is_refined(cell).then(|| slot.0 - grid.slots[cell]));
            regions.is_open[region] |= (0..3).any(|axis| steps[0][axis] == 0 || steps[1][axis] == last[axis]);
        }
    }
    regions
}

/// Joins the empty fine cells within one coarse cell.
fn within(grid: &TwoLevel, cell: usize, forest: &mut Forest<'_>) {
    let (frame, first) = (&grid.frame, grid.slots[cell]);
    let fine = frame.fine();
    for x in 0..fine[0] {
        for y in 0..fine[1] {
            for z in 0..fine[2] {
                let own = first + frame.place([x, y, z]);
                if !grid.is_empty(own) {
                    continue;
                }
                if x + 1 < fine[0] {
                    forest.join(grid, own, first + frame.place([x + 1, y, z]));
                }
                if y + 1 < fine[1] {
                    forest.join(grid, own, first + frame.place([x, y + 1, z]));
                }
                if z + 1 < fine[2] {
                    forest.join(grid, own, first + frame.place([x, y, z + 1]));
                }
            }
        }
    }
}

/// Joins the empty cells on both sides of the face between two coarse cells.
fn across(grid: &TwoLevel, cells: [usize; 2], axis: usize, forest: &mut Forest<'_>) {
    let frame = &grid.frame;
    let refined = cells.map(|cell| grid.is_refined(cell));
    if refined == [false; 2] {
        forest.join(grid, grid.slots[cells[0]], grid.slots[cells[1]]);
        return;
    }
    let others = [(axis + 1) % 3, (axis + 2) % 3];
    let fine = frame.fine();
    for i in 0..fine[others[0]] {
        for j in 0..fine[others[1]] {
            let slot = |side: usize| {
                let mut at = [0; 3];
                // The last layer before the face, or the first behind it.
                at[axis] = if side == 0 { fine[axis] - 1 } else { 0 };
                (at[others[0]], at[others[1]]) = (i, j);
                let first = grid.slots[cells[side]];
                if refined[side] { first + frame.place(at) } else { first }
            };
            forest.join(grid, slot(0), slot(1));
        }
    }
}
