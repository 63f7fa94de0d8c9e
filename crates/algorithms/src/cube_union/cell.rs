//! The vertices of the union in one cell of the grid.
//!
//! A cell that is no wider than a cube has at most one face of each cube for
//! each axis. With the faces sorted along an axis, the cubes that a face's
//! plane meets in the cell follow from those that came before: lower faces
//! passed, upper faces not yet passed, and cubes without a face there. All of
//! it fits in words of 64 bits, and a vertex is a triple of faces whose planes
//! meet, all three together, exactly the faces' owners.

use super::mass::{Kind, Mass};
use super::order::{ByIndex, Face};
use super::wide;

/// A cell with more cubes than this is divided, but no further than to a
/// quarter of a cube's edge.
const CROWD: usize = 24;
/// The cubes that a word holds: a cell with more is divided as far as it goes.
const WORD: usize = 64;

/// A box of points from the first to before the second coordinate, for each axis.
pub(super) type Range = [[i64; 2]; 3];

/// What is known along one axis: bit or row j belongs to cube j.
#[derive(Clone)]
struct Along {
    /// Cubes with their lower or upper face in the cell.
    faces: u64,
    /// Those of them that have the upper one there.
    upper: u64,
    /// Cubes without a face there.
    through: u64,
    /// For each cube with a face the cubes that its plane meets, itself included.
    cubes: [u64; WORD],
    /// For each cube the faces whose planes meet it, its own included.
    met: [u64; WORD],
    /// The faces' coordinates.
    at: [i64; WORD],
}

/// Memory for one cell after the other.
pub(super) struct Scratch {
    along: Box<[Along; 3]>,
    keys: Vec<u64>,
}

impl Scratch {
    pub(super) fn new() -> Scratch {
        let along = Along { faces: 0, upper: 0, through: 0, cubes: [0; WORD], met: [0; WORD], at: [0; WORD] };
        Scratch { along: Box::new([along.clone(), along.clone(), along]), keys: Vec::new() }
    }
}

/// The face of a cube in a range no wider than the cube: none, or whether it
/// is the upper one.
#[inline]
fn face_in(lower: i64, edge: i64, [from, to]: [i64; 2]) -> Option<bool> {
    let is_in = |at: i64| from <= at && at < to;
    if is_in(lower) {
        Some(false)
    } else if is_in(lower + edge) {
        Some(true)
    } else {
        None
    }
}

/// Adds what the cell's vertices contribute.
///
/// `cubes` from `first` on are all that reach the cell, the one with the
/// smallest index last; the list is the same when the call returns.
pub(super) fn add_cell(
    cubes: &mut Vec<[i64; 3]>,
    first: usize,
    edge: i64,
    cell: Range,
    scratch: &mut Scratch,
    mass: &mut Mass,
) {
    let count = cubes.len() - first;
    if count == 0 {
        return;
    }
    let widest = cell.iter().map(|[from, to]| to - from).max().unwrap_or(0);
    if widest > edge {
        return divide(cubes, first, edge, cell, scratch, mass);
    }
    if count > WORD || (count > CROWD && 4 * widest > edge) {
        if is_settled(&cubes[first..], edge, cell) {
            return;
        }
        if widest > 1 {
            return divide(cubes, first, edge, cell, scratch, mass);
        }
    }
    if count > WORD {
        add_crowd(&cubes[first..], edge, cell, mass)
    } else {
        add_few(&cubes[first..], edge, cell, scratch, mass)
    }
}

/// Whether the cell has no vertices: it is covered, or has no faces of some axis.
fn is_settled(cubes: &[[i64; 3]], edge: i64, cell: Range) -> bool {
    let mut any = [false; 3];
    for lower in cubes {
        let has: [bool; 3] = std::array::from_fn(|axis| face_in(lower[axis], edge, cell[axis]).is_some());
        if has == [false; 3] {
            return true;
        }
        (0..3).for_each(|axis| any[axis] |= has[axis]);
    }
    any != [true; 3]
}

/// The halves of a range; a point is not divided.
fn halves([from, to]: [i64; 2]) -> impl Iterator<Item = [i64; 2]> + Clone {
    let middle = from + (to - from) / 2;
    [[from, middle], [middle, to]].into_iter().filter(|[from, to]| from < to)
}

fn divide(cubes: &mut Vec<[i64; 3]>, first: usize, edge: i64, cell: Range, scratch: &mut Scratch, mass: &mut Mass) {
    let end = cubes.len();
    for x in halves(cell[0]) {
        for y in halves(cell[1]) {
            for z in halves(cell[2]) {
                let part = [x, y, z];
                for at in first..end {
                    let lower = cubes[at];
                    if (0..3).all(|axis| lower[axis] < part[axis][1] && lower[axis] + edge >= part[axis][0]) {
                        cubes.push(lower);
                    }
                }
                add_cell(cubes, end, edge, part, scratch, mass);
                cubes.truncate(end);
            }
        }
    }
}

impl Along {
    /// Looks at the cubes along one axis; false if none has a face in the range.
    #[inline]
    fn look(&mut self, cubes: &[[i64; 3]], axis: usize, edge: i64, range: [i64; 2], keys: &mut Vec<u64>) -> bool {
        [self.faces, self.upper, self.through] = [0; 3];
        keys.clear();
        for (j, lower) in cubes.iter().enumerate() {
            let bit = 1 << j;
            let Some(upper) = face_in(lower[axis], edge, range) else {
                self.through |= bit;
                continue;
            };
            let at = lower[axis] + if upper { edge } else { 0 };
            self.at[j] = at;
            self.faces |= bit;
            self.upper |= if upper { bit } else { 0 };
            // Ties by the place in the list, which has smaller indices later. (A range is below 2^57 wide.)
            keys.push(((at - range[0]).cast_unsigned() << 6) | j as u64);
        }
        sort(keys);
        let mut passed = 0;
        for key in keys.iter() {
            let j = (key % 64) as usize;
            let bit = 1 << j;
            let before = passed;
            passed |= bit;
            self.cubes[j] = (passed & !self.upper & self.faces) | (self.upper & !before) | self.through;
            self.met[j] = if self.upper & bit != 0 { passed } else { self.faces & !before };
        }
        let mut through = self.through;
        while through != 0 {
            self.met[through.trailing_zeros() as usize] = self.faces;
            through &= through - 1;
        }
        !keys.is_empty()
    }
}

/// By insertion: most cells have few faces.
#[inline]
fn sort(keys: &mut [u64]) {
    if keys.len() > 20 {
        keys.sort_unstable();
        return;
    }
    for end in 1..keys.len() {
        let key = keys[end];
        let mut at = end;
        while at > 0 && keys[at - 1] > key {
            keys[at] = keys[at - 1];
            at -= 1;
        }
        keys[at] = key;
    }
}

/// [`add_cell`] for cubes that fit in a word.
fn add_few(cubes: &[[i64; 3]], edge: i64, cell: Range, scratch: &mut Scratch, mass: &mut Mass) {
    let Scratch { along, keys } = scratch;
    let [x, y, z] = &mut **along;
    if !x.look(cubes, 0, edge, cell[0], keys)
        || !y.look(cubes, 1, edge, cell[1], keys)
        || !z.look(cubes, 2, edge, cell[2], keys)
        || x.through & y.through & z.through != 0
    {
        return;
    }
    let mut faces = x.faces;
    while faces != 0 {
        let a = faces.trailing_zeros() as usize;
        faces &= faces - 1;
        if x.cubes[a] & y.through & z.through & !(1 << a) != 0 {
            continue; // The face is covered.
        }
        let mut partners = x.cubes[a] & y.met[a];
        while partners != 0 {
            let b = partners.trailing_zeros() as usize;
            partners &= partners - 1;
            let owners = 1 << a | 1 << b;
            let both = x.cubes[a] & y.cubes[b];
            if both & z.through & !owners != 0 {
                continue; // The line is covered.
            }
            let mut ends = both & z.met[a] & z.met[b];
            while ends != 0 {
                let c = ends.trailing_zeros() as usize;
                ends &= ends - 1;
                // On the faces of its owners, and in no other cube.
                if both & z.cubes[c] == owners | 1 << c {
                    let upper = [x.upper >> a & 1 == 1, y.upper >> b & 1 == 1, z.upper >> c & 1 == 1];
                    mass.add(Kind::of([a, b, c]), [x.at[a], y.at[b], z.at[c]], upper);
                }
            }
        }
    }
}

/// [`add_cell`] for cubes that don't, in a cell that is a point: all faces
/// there coincide but for their perturbation.
fn add_crowd(cubes: &[[i64; 3]], edge: i64, cell: Range, mass: &mut Mass) {
    let lowers: Vec<[i64; 3]> = cubes.iter().rev().copied().collect();
    let order = ByIndex { lowers: &lowers, edge };
    let faces = [0, 1, 2].map(|axis| {
        let face =
            |(cube, lower): (u32, &[i64; 3])| Some(Face { cube, upper: face_in(lower[axis], edge, cell[axis])? });
        (0..).zip(&lowers).filter_map(face).collect::<Vec<Face>>()
    });
    let count = u32::try_from(lowers.len()).unwrap_or_else(|_| unreachable!("no more than there are indices"));
    wide::vertices(&order, count, [&faces[0], &faces[1], &faces[2]], |vertex| {
        let owners = vertex.map(|face| face.cube as usize);
        mass.add(Kind::of(owners), cell.map(|[from, _]| from), vertex.map(|face| face.upper));
    });
}
