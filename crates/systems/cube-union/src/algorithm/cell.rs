//! The vertices of the union in one cell of the grid.
//!
//! A cell that is no wider than a cube contains at most one face of each cube for each axis. Let the faces be sorted
//! along an axis. The cubes that a face's plane meets in the cell then follow from the previous faces. They are the
//! cubes whose lower face was passed, the cubes whose upper face was not yet passed, and the cubes without a face
//! there. All these sets fit in words of 64 bits. A vertex is a triple of faces such that the cubes that all three
//! planes meet are exactly the faces' owners.

use super::crowd::add_crowd;
use super::cube::{Cube, Range, reaches};
use super::mass::Mass;

/// The number of cubes above which a cell is divided, but no further than to a quarter of a cube's edge.
const CROWD: usize = 40;
/// The number of cubes in a word: a cell with more is divided as far as possible.
const WORD: usize = 64;
/// The maximum number of coordinates that are compared by pairs; more are sorted.
const PAIRS: usize = 16;

/// The faces and cubes along one axis: bit or row j belongs to cube j.
#[derive(Clone)]
struct Along {
    /// Cubes with their lower or upper face in the cell.
    faces: u64,
    /// Cubes with their upper face in the cell.
    upper: u64,
    /// Cubes without a face in the cell.
    through: u64,
    /// The faces' coordinates.
    at: [i64; WORD],
    /// For each cube with a face, the cubes that its plane meets, itself included.
    cubes: [u64; WORD],
    /// For each cube, the faces whose planes meet it, its own included.
    met: [u64; WORD],
}

/// Memory that is reused for each cell.
pub(super) struct Scratch {
    along: Box<[Along; 3]>,
    /// For each cube, the cubes before it.
    before: Box<[u64; WORD]>,
    keys: Vec<u64>,
    copy: Vec<Cube>,
    /// The cubes that own the x, y and z faces of the vertices found.
    vertices: Vec<[u8; 3]>,
}

impl Scratch {
    pub(super) fn new() -> Scratch {
        let along = Along { faces: 0, upper: 0, through: 0, at: [0; WORD], cubes: [0; WORD], met: [0; WORD] };
        Scratch {
            along: Box::new([along.clone(), along.clone(), along]),
            before: Box::new([0; WORD]),
            keys: Vec::new(),
            copy: Vec::new(),
            vertices: Vec::new(),
        }
    }
}

/// Adds the contribution of the cell's vertices.
///
/// `cubes` from `first` on are all that reach the cell. The function reorders them.
pub(super) fn add_cell(
    cubes: &mut Vec<Cube>,
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
    if (widest > edge || count > WORD || (count > CROWD && 4 * widest > edge)) && widest > 1 {
        return divide(cubes, first, edge, cell, scratch, mass);
    }
    sort(&mut cubes[first..], &mut scratch.copy);
    if count > WORD {
        add_crowd(&cubes[first..], edge, cell, mass)
    } else {
        add_few(&cubes[first..], edge, cell, scratch, mass)
    }
}

/// Sorts by descending index.
#[inline]
fn sort(cubes: &mut [Cube], copy: &mut Vec<Cube>) {
    let count = cubes.len();
    if count > WORD {
        cubes.sort_unstable_by_key(|cube| !cube.index);
        return;
    }
    // The number of larger indices gives a cube's position: random numbers are compared, but without branches.
    copy.clear();
    copy.extend_from_slice(cubes);
    let mut keys = [i32::MIN; WORD];
    for (key, cube) in keys.iter_mut().zip(copy.iter()) {
        *key = (cube.index ^ 1 << 31).cast_signed();
    }
    let (blocks, _) = keys.as_chunks::<8>();
    let blocks = &blocks[..count.div_ceil(8)];
    for (cube, &key) in copy.iter().zip(&keys) {
        let mut larger = [0_u32; 8];
        for block in blocks {
            (0..8).for_each(|lane| larger[lane] += u32::from(block[lane] > key));
        }
        cubes[larger.iter().sum::<u32>() as usize] = *cube;
    }
}

/// True if one of the cubes covers the cell.
pub(super) fn is_covered(cubes: &[Cube], edge: i64, cell: Range) -> bool {
    let covers = |lower: [i64; 3]| {
        let along = |axis: usize| (lower[axis] < cell[axis][0]) & (lower[axis] + edge >= cell[axis][1]);
        along(0) & along(1) & along(2)
    };
    cubes.iter().any(|cube| covers(cube.lower))
}

/// The bounding box of the faces in the cell, which contains its vertices too; `None` if some axis has no face.
fn bounds(cubes: &[Cube], edge: i64, cell: Range) -> Option<Range> {
    let mut bounds = [[i64::MAX, i64::MIN]; 3];
    for cube in cubes {
        for axis in 0..3 {
            for at in [cube.lower[axis], cube.lower[axis] + edge] {
                if cell[axis][0] <= at && at < cell[axis][1] {
                    let [from, to] = bounds[axis];
                    bounds[axis] = [from.min(at), to.max(at + 1)];
                }
            }
        }
    }
    bounds.iter().all(|[from, to]| from < to).then_some(bounds)
}

/// Adds the cell part by part: its halves along each axis, without the covered ones.
fn divide(cubes: &mut Vec<Cube>, first: usize, edge: i64, mut cell: Range, scratch: &mut Scratch, mass: &mut Mass) {
    let end = cubes.len();
    if end - first > WORD && cell.iter().all(|[from, to]| 4 * (to - from) < edge) {
        // If cubes are in few places, most of the cell is without faces.
        match bounds(&cubes[first..], edge, cell) {
            Some(bounds) => cell = bounds,
            None => return,
        }
    }
    // A point has an empty second half.
    let halves = cell.map(|[from, to]| {
        let middle = to - (to - from) / 2;
        [[from, middle], [middle, to]]
    });
    // Bit 4i + 2j + k: the half i along x, j along y and k along z.
    let mut covered = 0_u8;
    for cube in &cubes[first..] {
        let along = |axis: usize, masks: [u8; 2]| {
            let covers = |[from, to]: [i64; 2]| (cube.lower[axis] < from) & (cube.lower[axis] + edge >= to);
            [0, 1].map(|half| masks[half] & u8::from(covers(halves[axis][half])).wrapping_neg())
        };
        let ([x, more_x], [y, more_y], [z, more_z]) =
            (along(0, [0x0f, 0xf0]), along(1, [0x33, 0xcc]), along(2, [0x55, 0xaa]));
        covered |= (x | more_x) & (y | more_y) & (z | more_z);
        if covered == u8::MAX {
            return;
        }
    }
    for part in (0..8).filter(|part| covered >> part & 1 == 0) {
        let part = [halves[0][part >> 2], halves[1][part >> 1 & 1], halves[2][part & 1]];
        if part.iter().any(|[from, to]| from == to) {
            continue;
        }
        for at in first..end {
            let cube = cubes[at];
            if reaches(cube.lower, edge, part) {
                cubes.push(cube);
            }
        }
        add_cell(cubes, end, edge, part, scratch, mass);
        cubes.truncate(end);
    }
}

impl Along {
    /// Finds the cubes' faces along one axis; false if no cube has a face in the range.
    ///
    /// The code has no branches on coordinates: those of random cubes can't be predicted, and a misprediction costs
    /// more than a cube.
    #[inline]
    fn look(
        &mut self,
        cubes: &[Cube],
        axis: usize,
        edge: i64,
        [from, to]: [i64; 2],
        before: &mut [u64; WORD],
        keys: &mut Vec<u64>,
    ) -> bool {
        let (mut faces, mut upper) = (0, 0);
        for (j, Cube { lower, .. }) in cubes.iter().enumerate() {
            // The cube reaches the cell: if its lower face is before the cell, its upper face is not.
            let is_upper = lower[axis] < from;
            let at = lower[axis] + if is_upper { edge } else { 0 };
            self.at[j] = at;
            upper |= u64::from(is_upper) << j;
            faces |= u64::from(at < to) << j;
        }
        upper &= faces;
        if faces == 0 {
            return false;
        }
        let through = !faces & (u64::MAX >> (WORD - cubes.len()));
        precede(&self.at[..cubes.len()], from, before, keys);
        for j in 0..cubes.len() {
            let bit = 1 << j;
            let is_upper = upper & bit != 0;
            let before = before[j] & faces;
            let passed = before | bit;
            self.cubes[j] = (passed & faces & !upper) | (upper & !before) | through;
            let met = if is_upper { passed } else { faces & !before };
            self.met[j] = if faces & bit != 0 { met } else { faces };
        }
        [self.faces, self.upper, self.through] = [faces, upper, through];
        true
    }
}

/// For each coordinate, the coordinates before it: smaller ones, and equal ones that come earlier in the list. All are
/// at least `from` and at most 2^57 above it.
#[inline]
fn precede(at: &[i64], from: i64, before: &mut [u64; WORD], keys: &mut Vec<u64>) {
    if at.len() <= PAIRS {
        for (j, &b) in at.iter().enumerate() {
            let mut earlier = 0;
            for (i, &a) in at[..j].iter().enumerate() {
                let is_before = u64::from(a <= b);
                earlier |= is_before << i;
                before[i] |= (is_before ^ 1) << j;
            }
            before[j] = earlier;
        }
    } else {
        keys.clear();
        keys.extend((0..).zip(at).map(|(j, &a)| ((a - from).cast_unsigned() << 6) | j));
        keys.sort_unstable();
        let mut passed = 0;
        for key in keys.iter() {
            let j = key % 64;
            before[j as usize] = passed;
            passed |= 1 << j;
        }
    }
}

/// Does the work of [`add_cell`] for cubes that fit in a word; none of them covers the cell.
fn add_few(cubes: &[Cube], edge: i64, cell: Range, scratch: &mut Scratch, mass: &mut Mass) {
    let Scratch { along, before, keys, vertices, .. } = scratch;
    let [x, y, z] = &mut **along;
    if !x.look(cubes, 0, edge, cell[0], before, keys)
        || !y.look(cubes, 1, edge, cell[1], before, keys)
        || !z.look(cubes, 2, edge, cell[2], before, keys)
    {
        return;
    }
    let mut found = 0;
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
            if vertices.len() < found + WORD {
                vertices.resize(2 * (found + WORD), [0; 3]);
            }
            while ends != 0 {
                let c = ends.trailing_zeros() as usize;
                ends &= ends - 1;
                #[allow(clippy::cast_possible_truncation)] // below 64
                let owners_of_faces = [a, b, c].map(|owner| owner as u8);
                vertices[found] = owners_of_faces;
                // A vertex is on the faces of its owners, and in no other cube.
                found += usize::from(both & z.cubes[c] == owners | 1 << c);
            }
        }
    }
    for vertex in &vertices[..found] {
        let [a, b, c] = vertex.map(|owner| usize::from(owner) % WORD);
        let upper = [x.upper >> a & 1 == 1, y.upper >> b & 1 == 1, z.upper >> c & 1 == 1];
        mass.add([a, b, c], [x.at[a], y.at[b], z.at[c]], upper, 1);
    }
}
