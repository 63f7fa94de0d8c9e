//! The vertices of the union at a point where many cubes have their faces.
//!
//! Seen from so near, a cube is what its faces there leave of space: a half
//! space, a wedge or an octant, by its type: for each axis its lower face, its
//! upper face or none. All faces of a cube are moved by the same infinitesimal
//! p > 0 along all axes, so the cubes are translates of a few types along one
//! diagonal, in the order of their indices. Most of them need not be looked at:
//!
//! * *Hidden ones.* A type all of whose faces are lower ones, say x ≥ p and
//!   y ≥ p, is a set that shrinks as p grows. It contains every cube with a
//!   larger p that has the same faces, and maybe others. The same goes for types
//!   of upper faces, and smaller p. What is hidden has no vertices.
//! * *Runs.* Cubes of a mixed type, say x ≥ p and y ≤ p, contain none of each
//!   other. Let p₁ < … < pₖ be such cubes with no others left between them in the
//!   order, and let a vertex be on faces of some of them. Their faces have all the
//!   same order to those of any other cube, so the rest of the scene does not tell
//!   them apart. If all of the vertex's coordinates that come from the run are of
//!   one side, say ≥, it is on a face of the one with the smallest p (of the
//!   largest for ≤), or that one hides it. If x = pᵢ and y = pⱼ, it is on both
//!   faces if i ≥ j, and inside of all members between: so i = j or i = j + 1. So
//!   what there is at one place of the run is at all places, but for the ends: of
//!   the vertices whose last member is the second one there are as many for the
//!   third one, and so on to the last but one.
//!
//! So of a run only the first, the second and the last are kept, and what has
//! the second one as its last member counts k − 2 times. n identical cubes
//! take a time linear in n. Cubes of mixed types in an order that mixes
//! them as well are looked at as they are, all pairs with n bits each.

use super::cube::{Cube, Range, face_in};
use super::mass::Mass;
use super::order::{ByIndex, Face};
use super::wide;

/// For each axis: no face at the point, the lower one, the upper one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Type([Option<bool>; 3]);

impl Type {
    fn of(lower: [i64; 3], edge: i64, cell: Range) -> Type {
        Type([0, 1, 2].map(|axis| face_in(lower[axis], edge, cell[axis])))
    }

    fn has(self, upper: bool) -> bool {
        self.0.contains(&Some(upper))
    }

    /// A number below 27.
    fn code(self) -> usize {
        self.0.iter().fold(0, |code, face| 3 * code + face.map_or(0, |upper| 1 + usize::from(upper)))
    }

    /// Whether all faces of this type are of the other one as well.
    fn is_part_of(self, other: Type) -> bool {
        (0..3).all(|axis| self.0[axis].is_none() || self.0[axis] == other.0[axis])
    }
}

/// A cube that is kept.
struct Kept {
    lower: [i64; 3],
    /// The cube's type, and how many of its run it stands for.
    kind: Type,
    times: u64,
}

/// Adds the vertices at a point.
///
/// `cubes` are all that reach it, the one with the largest index, that is the smallest p, first.
pub(super) fn add_crowd(cubes: &[Cube], edge: i64, cell: Range, mass: &mut Mass) {
    let mut kept = runs(&visible(cubes, edge, cell));
    // Of two that stand beside each other in a run the one with the larger p is after the other.
    kept.reverse();
    let lowers: Vec<[i64; 3]> = kept.iter().map(|cube| cube.lower).collect();
    let order = ByIndex { lowers: &lowers, edge };
    let faces = [0, 1, 2].map(|axis| {
        let face = |(cube, kept): (u32, &Kept)| Some(Face { cube, upper: kept.kind.0[axis]? });
        (0..).zip(&kept).filter_map(face).collect::<Vec<Face>>()
    });
    let count = u32::try_from(lowers.len()).unwrap_or_else(|_| unreachable!("no more than there are indices"));
    wide::vertices(&order, count, [&faces[0], &faces[1], &faces[2]], |vertex| {
        let owners = vertex.map(|face| face.cube as usize);
        // The second one of a run, unless the vertex has the last one too. (No vertex has those of two runs.)
        let repeated = owners.iter().find(|&&owner| kept[owner].times > 1 && !owners.contains(&owner.wrapping_sub(1)));
        let times = repeated.map_or(1, |&owner| kept[owner].times);
        mass.add(owners, cell.map(|[from, _]| from), vertex.map(|face| face.upper), times);
    });
}

/// The cubes that no other one contains, near the point. (No cube covers the point.)
fn visible(cubes: &[Cube], edge: i64, cell: Range) -> Vec<Kept> {
    let kinds = || cubes.iter().map(|cube| Type::of(cube.lower, edge, cell));
    // Of each type without upper faces the first, of each without lower ones the last.
    let mut best: [Option<(Type, usize)>; 27] = [None; 27];
    for (at, kind) in kinds().enumerate() {
        let best = &mut best[kind.code()];
        if best.is_none() && !kind.has(true) || !kind.has(false) {
            *best = Some((kind, at));
        }
    }
    let best: Vec<(Type, usize)> = best.into_iter().flatten().collect();
    let is_hidden = |at: usize, kind: Type| {
        best.iter().any(|&(other, place)| {
            let is_further_out = if other.has(true) { at < place } else { place < at };
            other.is_part_of(kind) && is_further_out
        })
    };
    let seen =
        |(at, kind): (usize, Type)| (!is_hidden(at, kind)).then(|| Kept { lower: cubes[at].lower, kind, times: 1 });
    kinds().enumerate().filter_map(seen).collect()
}

/// With three for each longer run, the second of which stands for all but the ends.
fn runs(cubes: &[Kept]) -> Vec<Kept> {
    let mut kept = Vec::new();
    for run in cubes.chunk_by(|a, b| a.kind == b.kind) {
        let one = |cube: &Kept, times: u64| Kept { lower: cube.lower, kind: cube.kind, times };
        match run {
            [first, second, .., last] => {
                kept.extend([one(first, 1), one(second, run.len() as u64 - 2), one(last, 1)]);
            }
            _ => kept.extend(run.iter().map(|cube| one(cube, 1))),
        }
    }
    kept
}
