//! The vertices of a union for any order of the faces, consistent or not.
//!
//! Every pair of a face and a cube is queried once; the rest works on bits. Memory alone limits the number of cubes:
//! one bit for each pair of a face and a cube.

use predicament_predicates::{Axis, Sign};

use super::order::{Face, Order};

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

/// A table of bits in rows.
struct Rows {
    words: usize,
    bits: Vec<u64>,
}

impl Rows {
    fn new(rows: usize, columns: usize) -> Rows {
        let words = columns.div_ceil(64);
        Rows { words, bits: vec![0; rows * words] }
    }

    fn set(&mut self, row: usize, column: usize) {
        self.bits[row * self.words + column / 64] |= 1 << (column % 64);
    }

    fn row(&self, row: usize) -> &[u64] {
        &self.bits[row * self.words..][..self.words]
    }
}

fn has(row: &[u64], column: usize) -> bool {
    row[column / 64] >> (column % 64) & 1 == 1
}

/// The positions of the set bits, ascending.
fn ones(words: impl Iterator<Item = u64>) -> impl Iterator<Item = usize> {
    words.enumerate().flat_map(|(at, mut word)| {
        std::iter::from_fn(move || {
            let bit = (word != 0).then(|| word.trailing_zeros() as usize);
            word &= word.wrapping_sub(1);
            bit.map(|bit| 64 * at + bit)
        })
    })
}

/// The word with this index of the bit set of these items.
fn bits_of<const N: usize>(set: [usize; N], word: usize) -> u64 {
    set.iter().map(|&item| if item / 64 == word { 1 << (item % 64) } else { 0 }).fold(0, |bits, bit: u64| bits | bit)
}

/// The smallest and the largest member of a set, if it has any.
fn extremes(words: &[u64]) -> [Option<usize>; 2] {
    let first = words.iter().position(|&word| word != 0);
    let last = words.iter().rposition(|&word| word != 0);
    [
        first.map(|at| 64 * at + words[at].trailing_zeros() as usize),
        last.map(|at| 64 * at + 63 - words[at].leading_zeros() as usize),
    ]
}

/// The incidences of cubes and faces along one axis.
struct Reach {
    /// For each face, the cubes that its plane meets.
    cubes: Rows,
    /// For each cube, the faces whose planes meet it.
    faces: Rows,
    /// For each cube, its own faces.
    own: Rows,
}

impl Reach {
    /// `None` if faces of two cubes are in one plane. Every pair of them is compared: a face that is equal to a cube's
    /// upper face is not before its lower one.
    fn new<O: Order>(order: &O, axis: Axis, cubes: u32, faces: &[Face]) -> Option<Reach> {
        let count = cubes as usize;
        let [met, own] = [(); 2].map(|()| Rows::new(count, faces.len()));
        let mut reach = Reach { cubes: Rows::new(faces.len(), count), faces: met, own };
        for (at, &face) in faces.iter().enumerate() {
            reach.own.set(face.cube as usize, at);
            for cube in 0..cubes {
                match order.contact(axis, face, cube) {
                    Sign::Negative => {}
                    Sign::Zero => return None,
                    Sign::Positive => {
                        reach.cubes.set(at, cube as usize);
                        reach.faces.set(cube as usize, at);
                    }
                }
            }
        }
        Some(reach)
    }
}

/// Calls `found` with the three faces (x, y, z) of each vertex of the union of the cubes 0 to `cubes`. Only vertices on
/// one of these faces for each axis are reported. If faces of two cubes are in one plane, the answer is false, and
/// nothing is found.
pub(super) fn vertices<O: Order>(order: &O, cubes: u32, faces: [&[Face]; 3], mut found: impl FnMut([Face; 3])) -> bool {
    let along = |axis: usize| Reach::new(order, AXES[axis], cubes, faces[axis]);
    let (Some(x), Some(y), Some(z)) = (along(0), along(1), along(2)) else { return false };
    let (mut both, mut others) = (Vec::new(), Vec::new());
    for (at, &a) in faces[0].iter().enumerate() {
        let owner_a = a.cube as usize;
        let of_a = x.cubes.row(at);
        for at in ones(y.faces.row(owner_a).iter().copied()) {
            let b = faces[1][at];
            let owner_b = b.cube as usize;
            if !has(of_a, owner_b) {
                continue;
            }
            both.clear();
            both.extend(of_a.iter().zip(y.cubes.row(at)).map(|(a, b)| a & b));
            // A cube on the line must not meet the third face, or must own it. The first and the last such cube, which
            // are the extreme ones if ties go by index, leave few faces to try.
            others.clear();
            others.extend_from_slice(&both);
            [owner_a, owner_b].iter().for_each(|owner| others[owner / 64] &= !(1 << (owner % 64)));
            let rivals = extremes(&others).map(|rival| rival.unwrap_or(owner_a));
            let [free_of_one, free_of_other] = rivals.map(|rival| {
                let is_owner = rival == owner_a;
                let rows = z.faces.row(rival).iter().zip(z.own.row(rival));
                rows.map(move |(met, own)| if is_owner { u64::MAX } else { !met | own })
            });
            let meet_both = z.faces.row(owner_a).iter().zip(z.faces.row(owner_b)).map(|(a, b)| a & b);
            let free = free_of_one.zip(free_of_other).map(|(one, other)| one & other);
            for at in ones(meet_both.zip(free).map(|(met, free)| met & free)) {
                let c = faces[2][at];
                let owner_c = c.cube as usize;
                let owners = |word: usize| bits_of([owner_a, owner_b, owner_c], word);
                // A vertex is on the faces of its owners, and in no other cube.
                let of_c = z.cubes.row(at);
                if (0..both.len()).all(|word| both[word] & of_c[word] == owners(word)) {
                    found([a, b, c]);
                }
            }
        }
    }
    true
}
