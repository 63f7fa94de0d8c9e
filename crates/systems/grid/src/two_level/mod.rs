//! A uniform grid in space of two levels: crowded cells have a nested grid.
//!
//! This is the grid of PinMesh and of 3D-EPUG-Overlay (Magalhães, *Exact and parallel intersection of 3D triangular
//! meshes*, section 4.4). Only the cells that need it are refined, so the grid is adaptive at the price of one more
//! look-up.
//!
//! # Why no incidence is lost
//! Along each axis one monotone function (`Steps`, in `steps.rs`) maps a coordinate to one of coarse × fine steps. The
//! coarse step is that divided by the number of fine cells, a power of two, which is monotone too. A box is listed in
//! each cell between the steps of its lowest and those of its highest coordinates. So each point of a box is in a cell
//! that lists the box, for any coordinates and any rounding; and an empty cell contains no point of any box.
//!
//! # Cost
//! A build counts, computes prefix sums, and fills the lists, in parallel: it is linear in boxes, cells and entries.
//! Entries of a cell are ascending, so the grid does not depend on the number of threads. [`Sizes::of`] chooses at most
//! [`MOST_ENTRIES`] entries per box, and about one coarse cell for [`COARSE_BOXES`] boxes. [`TwoLevel::bytes`] gives
//! the memory.

mod build;
mod empty;
mod sizes;

use rayon::prelude::*;

use crate::Bounds;
use crate::steps::Steps;

pub use empty::EmptyRegions;
pub use sizes::{COARSE_BOXES, MOST_ENTRIES, Sizes};

/// The mark of a missing number.
const NONE: u32 = u32::MAX;

/// A grid over boxes; a box is identified by its index 0, 1, 2 ….
#[derive(Clone, PartialEq, Debug)]
pub struct TwoLevel {
    frame: Frame,
    /// The first slot of each coarse cell, and at the end the number of slots. A refined cell has a slot for each of
    /// its fine cells, other cells have one.
    slots: Vec<u32>,
    /// The index of each slot's first entry, and at the end the number of entries.
    starts: Vec<u32>,
    entries: Vec<u32>,
}

/// The geometry of the cells.
#[derive(Clone, PartialEq, Debug)]
struct Frame {
    steps: [Steps; 3],
    /// The number of coarse cells along each axis.
    coarse: [u32; 3],
    /// The binary logarithm of the number of fine cells per coarse cell along each axis: zero along axes without
    /// extent.
    shift: [u32; 3],
}

/// A leaf cell: a fine cell, or a coarse cell that is not refined.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Slot(u32);

/// The direction of a ray.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Ray {
    /// The axis of the ray, 0 for x.
    pub axis: usize,
    /// True if the ray goes to larger coordinates.
    pub is_up: bool,
}

impl Ray {
    /// The direction up the z axis.
    pub const UP: Ray = Ray { axis: 2, is_up: true };
    /// The directions up and down each axis.
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
    /// The index of the slot, below [`TwoLevel::slots`].
    #[inline]
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

impl Frame {
    /// A frame of this many cells over the bounding box of all boxes.
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

    /// The number of fine cells per coarse cell along each axis.
    fn fine(&self) -> [u32; 3] {
        self.shift.map(|shift| 1 << shift)
    }

    // Without closures: closures over arrays are not always inlined, and every query calls this.

    /// The fine steps of a point.
    #[inline]
    fn steps(&self, [x, y, z]: [f64; 3]) -> [u32; 3] {
        [self.steps[0].short(x), self.steps[1].short(y), self.steps[2].short(z)]
    }

    /// The first and the last fine steps that a box reaches.
    fn range(&self, one: &Bounds<3>) -> [[u32; 3]; 2] {
        [self.steps(one.low), self.steps(one.high)]
    }

    /// The number of coarse cells.
    fn count(&self) -> usize {
        self.coarse.iter().map(|&count| count as usize).product()
    }

    /// The index of a coarse cell: columns along z are contiguous.
    #[inline]
    fn cell(&self, [x, y, z]: [u32; 3]) -> usize {
        (x as usize * self.coarse[1] as usize + y as usize) * self.coarse[2] as usize + z as usize
    }

    /// True if a coarse cell is at the border.
    fn is_at_border(&self, cell: usize) -> bool {
        let [nx, ny, nz] = self.coarse.map(|count| count as usize);
        let at = [cell / nz / ny, cell / nz % ny, cell % nz];
        at.contains(&0) || at[0] + 1 == nx || at[1] + 1 == ny || at[2] + 1 == nz
    }

    /// The coarse step of a fine step, along each axis.
    #[inline]
    fn coarse_of(&self, [x, y, z]: [u32; 3]) -> [u32; 3] {
        [x >> self.shift[0], y >> self.shift[1], z >> self.shift[2]]
    }

    /// The first and the last fine steps of a coarse cell, or of one of its fine cells.
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

    /// The index of a fine cell in its coarse cell.
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

    /// The cell of a point; a point outside of all boxes goes to the nearest cell.
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

    /// The boxes that a cell lists, by the index of the cell, ascending. Two boxes that meet share at least one list.
    ///
    /// # Panics
    /// If `slot` is not below [`slots`](TwoLevel::slots).
    #[inline]
    #[must_use]
    pub fn list(&self, slot: usize) -> &[u32] {
        &self.entries[self.starts[slot] as usize..self.starts[slot + 1] as usize]
    }

    /// The number of leaf cells.
    #[must_use]
    pub fn slots(&self) -> usize {
        self.starts.len() - 1
    }

    /// The number of refined coarse cells.
    #[must_use]
    pub fn refined(&self) -> usize {
        self.slots.windows(2).filter(|pair| pair[1] - pair[0] > 1).count()
    }

    /// The number of entries in all cells.
    #[must_use]
    pub fn all_entries(&self) -> usize {
        self.entries.len()
    }

    /// The memory of the grid in bytes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of::<u32>() * (self.slots.len() + self.starts.len() + self.entries.len())
    }

    /// The fine step of a coordinate along an axis, 0 for x. A box is listed in the cells from the step of its lowest
    /// coordinate to that of its highest.
    #[inline]
    #[must_use]
    pub fn step(&self, axis: usize, x: f64) -> u32 {
        self.frame.steps[axis].short(x)
    }

    /// Visits the cells that an axis-parallel ray from a point passes, from the point's cell on, each once, with the
    /// last step of each along the ray. Ends when `visit` returns true.
    ///
    /// A box that the ray meets is listed in one of these cells. A box that is in no list up to a cell is wholly beyond
    /// the last step of that cell.
    #[inline]
    pub fn along(&self, p: [f64; 3], ray: Ray, mut visit: impl FnMut(Slot, &[u32], u32) -> bool) {
        let mut steps = self.frame.steps(p);
        let within = (1 << self.frame.shift[ray.axis]) - 1;
        let top = number(self.frame.steps[ray.axis].count()) - 1;
        loop {
            let slot = self.slot_of(steps);
            let at = steps[ray.axis];
            // The next fine step in a refined cell, otherwise the next coarse one.
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

    /// Visits the cells that a box reaches into, each once: their lists contain all boxes that meet it.
    pub fn within(&self, one: &Bounds<3>, mut visit: impl FnMut(Slot, &[u32])) {
        build::each_slot(self, one, |slot| {
            let slot = Slot(number(slot));
            visit(slot, self.entries(slot));
        });
    }

    /// A point about in the middle of a cell; `None` if the cell contains no double along an axis.
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

    /// The regions of empty cells: any two cells of a region are connected by a path through empty cells.
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

/// The number of boxes that one thread takes at a time.
const PART: usize = 4096;

/// The bounding box of all boxes.
fn bounds(boxes: &[Bounds<3>]) -> Bounds<3> {
    let parts = boxes.par_chunks(PART).map(|part| part.iter().fold(Bounds::NOTHING, |all, one| all.union(one)));
    parts.reduce(|| Bounds::NOTHING, |all, one| all.union(&one))
}

fn number(n: usize) -> u32 {
    u32::try_from(n).expect("fewer than 2^32 boxes, cells and entries")
}
