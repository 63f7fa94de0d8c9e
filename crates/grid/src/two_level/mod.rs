//! A uniform grid in space of two levels: cells that hold many boxes have a grid of their own.
//!
//! This is the grid of PinMesh and of 3D-EPUG-Overlay (Magalhães, *Exact and parallel intersection of 3D triangular meshes*,
//! section 4.4): refining only the cells that need it makes it adaptive at the price of two divisions a look-up.
//!
//! # Why no incidence is lost
//! Along each axis one monotone function (`Steps`, in `steps.rs`) maps a coordinate to one of coarse × fine steps; the coarse step is
//! that divided by `fine`, which is monotone too. A box is listed in each cell between the steps of its lowest and those of
//! its highest coordinates. So each point of a box is in a cell that lists the box, whatever the coordinates and
//! however they were rounded; and a cell that lists nothing has no point of any box.
//!
//! # Cost
//! Building counts, adds up, and fills: linear in boxes, cells and entries, in parallel. Entries of a cell are ascending, so that the
//! grid is the same for any number of threads. [`Sizes::of`] chooses no more than [`MOST_ENTRIES`] entries a box, and about
//! one coarse cell for [`COARSE_BOXES`] boxes: [`TwoLevel::bytes`] tells what it comes to.

mod build;
mod empty;
mod sizes;

use crate::Bounds;
use crate::steps::Steps;

pub use empty::EmptyRegions;
pub use sizes::{COARSE_BOXES, MOST_ENTRIES, Sizes};

/// The number that names nothing.
const NONE: u32 = u32::MAX;

/// A grid over boxes, which are known by their places 0, 1, 2 ….
#[derive(Clone, PartialEq, Debug)]
pub struct TwoLevel {
    frame: Frame,
    /// For each coarse cell the number of its first slot; a refined cell has a slot for each of its fine ones, others have one. The number of slots.
    slots: Vec<u32>,
    /// For each slot the place of its first entry, and the number of entries.
    starts: Vec<u32>,
    entries: Vec<u32>,
}

/// Where cells are.
#[derive(Clone, PartialEq, Debug)]
struct Frame {
    steps: [Steps; 3],
    /// Coarse cells along each axis.
    coarse: [u32; 3],
    /// Fine cells to a coarse one along each axis: one along those without extent.
    fine: [u32; 3],
}

/// A cell without finer ones.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Slot(u32);

impl Slot {
    /// From 0 to [`TwoLevel::slots`].
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

impl Frame {
    fn new(boxes: &[Bounds<3>], sizes: Sizes) -> Frame {
        let all = boxes.iter().fold(Bounds::NOTHING, |all, one| all.union(one));
        let (mut coarse, mut fine) = ([1; 3], [sizes.fine.max(1); 3]);
        let steps = [0, 1, 2].map(|axis: usize| {
            let extent = if boxes.is_empty() { [0.0; 2] } else { [all.low[axis], all.high[axis]] };
            let steps = Steps::new(extent, sizes.coarse[axis].max(1) as usize * fine[axis] as usize);
            if steps.count() == 1 {
                fine[axis] = 1;
            }
            coarse[axis] = number(steps.count()) / fine[axis];
            steps
        });
        Frame { steps, coarse, fine }
    }

    /// The fine steps of a point.
    fn steps(&self, p: [f64; 3]) -> [u32; 3] {
        [0, 1, 2].map(|axis: usize| number(self.steps[axis].of(p[axis])))
    }

    /// The fine steps from where to where a box goes.
    fn range(&self, one: &Bounds<3>) -> [[u32; 3]; 2] {
        [self.steps(one.low), self.steps(one.high)]
    }

    /// The number of coarse cells.
    fn count(&self) -> usize {
        self.coarse.iter().map(|&count| count as usize).product()
    }

    /// The number of a coarse cell: columns along z are contiguous.
    fn cell(&self, [x, y, z]: [u32; 3]) -> usize {
        (x as usize * self.coarse[1] as usize + y as usize) * self.coarse[2] as usize + z as usize
    }

    /// The coarse cell of a fine one, along each axis.
    fn coarse_of(&self, steps: [u32; 3]) -> [u32; 3] {
        [0, 1, 2].map(|axis: usize| steps[axis] / self.fine[axis])
    }

    /// The place of a fine cell in its coarse one.
    fn place(&self, [x, y, z]: [u32; 3]) -> u32 {
        (x * self.fine[1] + y) * self.fine[2] + z
    }
}

impl TwoLevel {
    /// A grid over these boxes.
    ///
    /// # Panics
    /// If there are 2^32 boxes, slots or entries.
    #[must_use]
    pub fn new(boxes: &[Bounds<3>], sizes: Sizes) -> TwoLevel {
        build::build(boxes, sizes)
    }

    /// The cell of a point; what lies outside of all boxes goes to the nearest one.
    #[must_use]
    pub fn at(&self, p: [f64; 3]) -> Slot {
        self.slot_of(self.frame.steps(p))
    }

    /// The boxes that a cell lists, ascending.
    #[must_use]
    pub fn entries(&self, slot: Slot) -> &[u32] {
        &self.entries[self.starts[slot.index()] as usize..self.starts[slot.index() + 1] as usize]
    }

    /// The number of cells without finer ones.
    #[must_use]
    pub fn slots(&self) -> usize {
        self.starts.len() - 1
    }

    /// The number of coarse cells that have finer ones.
    #[must_use]
    pub fn refined(&self) -> usize {
        self.slots.windows(2).filter(|pair| pair[1] - pair[0] > 1).count()
    }

    /// The number of entries in all cells.
    #[must_use]
    pub fn all_entries(&self) -> usize {
        self.entries.len()
    }

    /// The memory that it takes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of::<u32>() * (self.slots.len() + self.starts.len() + self.entries.len())
    }

    /// Visits the cells that a ray straight up from a point passes, from the point's own on, each once; ends where `visit` says
    /// that it has seen enough.
    ///
    /// A box that has a point above p, on the same vertical line, is listed in one of them. Of boxes that are listed in none
    /// of the cells up to one, all is above that cell.
    pub fn upward(&self, p: [f64; 3], mut visit: impl FnMut(Slot, &[u32]) -> bool) {
        let [x, y, mut z] = self.frame.steps(p);
        let fine = self.frame.fine[2];
        let top = number(self.frame.steps[2].count());
        while z < top {
            let slot = self.slot_of([x, y, z]);
            if visit(slot, self.entries(slot)) {
                return;
            }
            // The next fine step in a refined cell, else the next coarse one.
            let cell = self.frame.cell(self.frame.coarse_of([x, y, z]));
            z = if self.is_refined(cell) { z + 1 } else { (z / fine + 1) * fine };
        }
    }

    /// The cells that list nothing, in regions: one can go from each cell of a region to each other without leaving cells that
    /// list nothing.
    #[must_use]
    pub fn empty_regions(&self) -> EmptyRegions {
        empty::regions(self)
    }

    fn is_refined(&self, cell: usize) -> bool {
        self.slots[cell + 1] - self.slots[cell] > 1
    }

    fn slot_of(&self, steps: [u32; 3]) -> Slot {
        let cell = self.frame.cell(self.frame.coarse_of(steps));
        if self.is_refined(cell) {
            let place = [0, 1, 2].map(|axis: usize| steps[axis] % self.frame.fine[axis]);
            Slot(self.slots[cell] + self.frame.place(place))
        } else {
            Slot(self.slots[cell])
        }
    }
}

fn number(n: usize) -> u32 {
    u32::try_from(n).expect("fewer than 2^32 boxes, cells and entries")
}
