//! A uniform grid in space of two levels: cells that hold many boxes have a grid of their own.
//!
//! This is the grid of PinMesh and of 3D-EPUG-Overlay (Magalhães, *Exact and parallel intersection of 3D triangular meshes*,
//! section 4.4): refining only the cells that need it makes it adaptive at the price of one more look-up.
//!
//! # Why no incidence is lost
//! Along each axis one monotone function (`Steps`, in `steps.rs`) maps a coordinate to one of coarse × fine steps; the coarse step is
//! that divided by the number of fine cells, a power of two, which is monotone too. A box is listed in each cell between the steps of its lowest and those of
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

use rayon::prelude::*;

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
    /// The exponents of 2 of the numbers of fine cells to a coarse one along each axis: zero along those without extent.
    shift: [u32; 3],
}

/// A cell without finer ones.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Slot(u32);

/// Which way a ray goes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Ray {
    /// The axis that it is parallel to, 0 for x.
    pub axis: usize,
    /// Whether it goes to larger coordinates.
    pub is_up: bool,
}

impl Ray {
    /// Straight up the z axis.
    pub const UP: Ray = Ray { axis: 2, is_up: true };
    /// Up and down each axis.
    pub const ALL: [Ray; 6] = [
        Ray::UP,
        Ray { axis: 2, is_up: false },
        Ray { axis: 0, is_up: true },
        Ray { axis: 0, is_up: false },
        Ray { axis: 1, is_up: true },
        Ray { axis: 1, is_up: false },
    ];
}

impl Slot {
    /// From 0 to [`TwoLevel::slots`].
    #[inline]
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

impl Frame {
    /// Cells over the smallest box that holds all boxes, of so many.
    fn new(all: &Bounds<3>, sizes: Sizes) -> Frame {
        let fine = sizes.fine.max(1).checked_next_power_of_two().expect("fewer than 2^32 fine cells");
        let (mut coarse, mut shift) = ([1; 3], [fine.trailing_zeros(); 3]);
        let steps = [0, 1, 2].map(|axis: usize| {
            let extent = if all.low[axis] > all.high[axis] { [0.0; 2] } else { [all.low[axis], all.high[axis]] };
            let steps = Steps::new(extent, sizes.coarse[axis].max(1) as usize * fine as usize);
            if steps.count() == 1 {
                shift[axis] = 0;
            }
            coarse[axis] = number(steps.count()) >> shift[axis];
            steps
        });
        Frame { steps, coarse, shift }
    }

    /// The number of fine cells to a coarse one along each axis.
    fn fine(&self) -> [u32; 3] {
        self.shift.map(|shift| 1 << shift)
    }

    // Written out: closures over arrays are not always inlined, and every query comes through here.

    /// The fine steps of a point.
    #[inline]
    fn steps(&self, [x, y, z]: [f64; 3]) -> [u32; 3] {
        [self.steps[0].short(x), self.steps[1].short(y), self.steps[2].short(z)]
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
    #[inline]
    fn cell(&self, [x, y, z]: [u32; 3]) -> usize {
        (x as usize * self.coarse[1] as usize + y as usize) * self.coarse[2] as usize + z as usize
    }

    /// Whether a coarse cell is at the border.
    fn is_at_border(&self, cell: usize) -> bool {
        let [nx, ny, nz] = self.coarse.map(|count| count as usize);
        let at = [cell / nz / ny, cell / nz % ny, cell % nz];
        at.contains(&0) || at[0] + 1 == nx || at[1] + 1 == ny || at[2] + 1 == nz
    }

    /// The coarse cell of a fine one, along each axis.
    #[inline]
    fn coarse_of(&self, [x, y, z]: [u32; 3]) -> [u32; 3] {
        [x >> self.shift[0], y >> self.shift[1], z >> self.shift[2]]
    }

    /// The first and the last fine steps of a coarse cell, or of one of its fine ones.
    fn steps_of(&self, cell: usize, place: Option<u32>) -> [[u32; 3]; 2] {
        let [ny, nz] = [self.coarse[1] as usize, self.coarse[2] as usize];
        let coarse = [cell / nz / ny, cell / nz % ny, cell % nz].map(number);
        let fine = self.fine();
        let first = [0, 1, 2].map(|axis: usize| coarse[axis] * fine[axis]);
        match place {
            None => [first, [0, 1, 2].map(|axis: usize| first[axis] + fine[axis] - 1)],
            Some(place) => {
                let [_, fy, fz] = fine;
                let parts = [place / fz / fy, place / fz % fy, place % fz];
                [[0, 1, 2].map(|axis: usize| first[axis] + parts[axis]); 2]
            }
        }
    }

    /// The place of a fine cell in its coarse one.
    #[inline]
    fn place(&self, [x, y, z]: [u32; 3]) -> u32 {
        (((x << self.shift[1]) + y) << self.shift[2]) + z
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
    #[inline]
    #[must_use]
    pub fn at(&self, p: [f64; 3]) -> Slot {
        self.slot_of(self.frame.steps(p))
    }

    /// The boxes that a cell lists, ascending.
    #[inline]
    #[must_use]
    pub fn entries(&self, slot: Slot) -> &[u32] {
        self.list(slot.index())
    }

    /// The boxes that a cell lists, by the number of the cell, ascending. Two boxes that meet are listed together somewhere.
    ///
    /// # Panics
    /// If there are no more than so many [slots](TwoLevel::slots).
    #[inline]
    #[must_use]
    pub fn list(&self, slot: usize) -> &[u32] {
        &self.entries[self.starts[slot] as usize..self.starts[slot + 1] as usize]
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

    /// The fine step of a coordinate along an axis, 0 for x; the cells that a box is listed in are those from the step of its lowest
    /// coordinate to that of its highest.
    #[inline]
    #[must_use]
    pub fn step(&self, axis: usize, x: f64) -> u32 {
        self.frame.steps[axis].short(x)
    }

    /// Visits the cells that a ray from a point passes, straight up an axis or straight down it, from the point's own cell on, each
    /// once, with the last step of each along the ray; ends where `visit` says that it has seen enough.
    ///
    /// A box that the ray meets is listed in one of them. A box that is listed in none of the cells up to one lies wholly
    /// beyond the last step of that one.
    #[inline]
    pub fn along(&self, p: [f64; 3], ray: Ray, mut visit: impl FnMut(Slot, &[u32], u32) -> bool) {
        let mut steps = self.frame.steps(p);
        let within = (1 << self.frame.shift[ray.axis]) - 1;
        let top = number(self.frame.steps[ray.axis].count()) - 1;
        loop {
            let slot = self.slot_of(steps);
            let at = steps[ray.axis];
            // The next fine step in a refined cell, else the next coarse one.
            let is_fine = self.is_refined(self.frame.cell(self.frame.coarse_of(steps)));
            let last = match (is_fine, ray.is_up) {
                (true, _) => at,
                (false, true) => at | within,
                (false, false) => at & !within,
            };
            let is_end = if ray.is_up { last >= top } else { last == 0 };
            if visit(slot, self.entries(slot), last) || is_end {
                return;
            }
            steps[ray.axis] = if ray.is_up { last + 1 } else { last - 1 };
        }
    }

    /// Visits the cells that a box reaches into, each once: all boxes that meet it are listed in them.
    pub fn within(&self, one: &Bounds<3>, mut visit: impl FnMut(Slot, &[u32])) {
        build::each_slot(self, one, |slot| {
            let slot = Slot(number(slot));
            visit(slot, self.entries(slot));
        });
    }

    /// A point about in the middle of a cell; none where the cell has no double along an axis.
    #[must_use]
    pub fn middle(&self, slot: Slot) -> Option<[f64; 3]> {
        let [first, last] = self.steps_of(slot);
        let along = |axis: usize| self.frame.steps[axis].middle(first[axis] as usize, last[axis] as usize);
        Some([along(0)?, along(1)?, along(2)?])
    }

    /// The first and the last fine steps of a cell.
    fn steps_of(&self, slot: Slot) -> [[u32; 3]; 2] {
        let cell = self.slots.partition_point(|&first| first <= slot.0) - 1;
        self.frame.steps_of(cell, self.is_refined(cell).then(|| slot.0 - self.slots[cell]))
    }

    /// The cells that list nothing, in regions: one can go from each cell of a region to each other without leaving cells that
    /// list nothing.
    #[must_use]
    pub fn empty_regions(&self) -> EmptyRegions {
        empty::regions(self)
    }

    #[inline]
    fn is_refined(&self, cell: usize) -> bool {
        self.slots[cell + 1] - self.slots[cell] > 1
    }

    #[inline]
    fn slot_of(&self, steps: [u32; 3]) -> Slot {
        let cell = self.frame.cell(self.frame.coarse_of(steps));
        let [first, next] = [self.slots[cell], self.slots[cell + 1]];
        if next - first > 1 {
            let within = self.frame.fine();
            let [x, y, z] = steps;
            Slot(first + self.frame.place([x & (within[0] - 1), y & (within[1] - 1), z & (within[2] - 1)]))
        } else {
            Slot(first)
        }
    }
}

/// Boxes that one thread takes at a time.
const PART: usize = 4096;

/// The smallest box that holds all boxes.
fn bounds(boxes: &[Bounds<3>]) -> Bounds<3> {
    let parts = boxes.par_chunks(PART).map(|part| part.iter().fold(Bounds::NOTHING, |all, one| all.union(one)));
    parts.reduce(|| Bounds::NOTHING, |all, one| all.union(&one))
}

fn number(n: usize) -> u32 {
    u32::try_from(n).expect("fewer than 2^32 boxes, cells and entries")
}
