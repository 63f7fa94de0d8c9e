//! Regions of cells that list nothing.

use super::{NONE, Slot, TwoLevel};

/// Regions of empty cells, numbered by their first slots.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct EmptyRegions {
    /// For each slot its region.
    region: Vec<u32>,
    /// A slot of each region: its first.
    first: Vec<Slot>,
    /// For each region whether one of its cells is at the border of the grid.
    is_open: Vec<bool>,
}

impl EmptyRegions {
    /// The region of an empty cell; none of one that lists something.
    #[must_use]
    pub fn of(&self, slot: Slot) -> Option<usize> {
        self.of_index(slot.index())
    }

    /// The region of the cell with this index, as [`EmptyRegions::of`].
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

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.first.is_empty()
    }

    /// The first cell of each region.
    #[must_use]
    pub fn first(&self) -> &[Slot] {
        &self.first
    }

    /// Whether a region goes on outside of the grid: what is outside of all boxes is in such regions.
    #[must_use]
    pub fn is_open(&self, region: usize) -> bool {
        self.is_open[region]
    }

    /// The memory that they take.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of::<u32>() * (self.region.len() + self.first.len()) + self.is_open.len()
    }
}

/// Finds the regions by union-find; cells with a common face are neighbours.
///
/// Cells are the points that the monotone maps send to them. Of two neighbours' common face each point is in one of them, so that the
/// way from one to the other leaves neither.
pub(super) fn regions(grid: &TwoLevel) -> EmptyRegions {
    let frame = &grid.frame;
    let is_empty = |slot: u32| grid.starts[slot as usize] == grid.starts[slot as usize + 1];
    let mut parent: Vec<u32> = (0..super::number(grid.slots())).collect();
    let [nx, ny, nz] = frame.coarse;
    for x in 0..nx {
        for y in 0..ny {
            for z in 0..nz {
                let cell = frame.cell([x, y, z]);
                if grid.is_refined(cell) {
                    within(grid, cell, &mut parent, is_empty);
                }
                let after = [[x + 1, y, z], [x, y + 1, z], [x, y, z + 1]];
                for (axis, next) in
                    after.into_iter().enumerate().filter(|(axis, next)| next[*axis] < frame.coarse[*axis])
                {
                    across(grid, [cell, frame.cell(next)], axis, &mut parent, is_empty);
                }
            }
        }
    }
    let mut regions = EmptyRegions { region: vec![NONE; parent.len()], first: Vec::new(), is_open: Vec::new() };
    for slot in (0..super::number(parent.len())).filter(|&slot| is_empty(slot)) {
        let root = root(&mut parent, slot);
        if root == slot {
            regions.region[slot as usize] = super::number(regions.first.len());
            regions.first.push(Slot(slot));
        } else {
            // A region begins with its lowest slot.
            regions.region[slot as usize] = regions.region[root as usize];
        }
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

/// Joins the empty fine cells of one coarse cell.
fn within(grid: &TwoLevel, cell: usize, parent: &mut [u32], is_empty: impl Fn(u32) -> bool) {
    let (frame, first, fine) = (&grid.frame, grid.slots[cell], grid.frame.fine());
    for x in 0..fine[0] {
        for y in 0..fine[1] {
            for z in 0..fine[2] {
                let own = first + frame.place([x, y, z]);
                let after = [[x + 1, y, z], [x, y + 1, z], [x, y, z + 1]];
                for next in after.into_iter().filter(|next| next.iter().zip(&fine).all(|(step, fine)| step < fine)) {
                    join(parent, own, first + frame.place(next), &is_empty);
                }
            }
        }
    }
}

/// Joins the empty cells on both sides of the face between two coarse cells.
fn across(grid: &TwoLevel, cells: [usize; 2], axis: usize, parent: &mut [u32], is_empty: impl Fn(u32) -> bool) {
    let frame = &grid.frame;
    let refined = cells.map(|cell| grid.is_refined(cell));
    if refined == [false; 2] {
        join(parent, grid.slots[cells[0]], grid.slots[cells[1]], &is_empty);
        return;
    }
    let others = [(axis + 1) % 3, (axis + 2) % 3];
    let fine = frame.fine();
    for i in 0..fine[others[0]] {
        for j in 0..fine[others[1]] {
            let slot = |side: usize| {
                let mut at = [0; 3];
                // The last layer before the face, the first behind it.
                at[axis] = if side == 0 { fine[axis] - 1 } else { 0 };
                (at[others[0]], at[others[1]]) = (i, j);
                let first = grid.slots[cells[side]];
                if refined[side] { first + frame.place(at) } else { first }
            };
            join(parent, slot(0), slot(1), &is_empty);
        }
    }
}

fn join(parent: &mut [u32], a: u32, b: u32, is_empty: &impl Fn(u32) -> bool) {
    if is_empty(a) && is_empty(b) {
        let [a, b] = [root(parent, a), root(parent, b)];
        parent[a.max(b) as usize] = a.min(b);
    }
}

/// The lowest of a class.
fn root(parent: &mut [u32], mut slot: u32) -> u32 {
    while parent[slot as usize] != slot {
        parent[slot as usize] = parent[parent[slot as usize] as usize];
        slot = parent[slot as usize];
    }
    slot
}
