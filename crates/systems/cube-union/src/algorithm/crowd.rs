//! The vertices of the union at a point where many cubes have their faces.
//!
//! Near the point, a cube equals a half space, a wedge or an octant. Its type says which: for each axis its lower face,
//! its upper face or none. All faces of a cube are moved by the same infinitesimal p > 0 along all axes, so the cubes
//! are translates of a few types along one diagonal, in the order of their indices. Most of the cubes can be skipped:
//!
//! - *Hidden cubes.* A type with only lower faces, say x ≥ p and y ≥ p, is a set that shrinks as p grows. It contains
//!   every cube with a larger p that has the same faces, and maybe others. The same holds for types with only upper
//!   faces, and smaller p. A hidden cube has no vertices.
//! - *Runs.* Cubes of one mixed type, say x ≥ p and y ≤ p, do not contain each other. Let p₁ < … < pₖ be such cubes
//!   without other remaining cubes between them in the order, and let a vertex be on faces of some of them. Their faces
//!   all have the same order relative to those of any other cube, so the rest of the scene does not distinguish them.
//!   Suppose that all of the vertex's coordinates that come from the run are of one side, say ≥. Then it is on a face
//!   of the cube with the smallest p (of the largest for ≤), or that cube hides it. If x = pᵢ and y = pⱼ, it is on both
//!   faces if i ≥ j, and inside of all members between: so i = j or i = j + 1. So each position of the run, except at
//!   the ends, has the same vertices. The number of vertices whose last member is the second cube equals the number for
//!   the third cube, and so on to the last but one.
//!
//! The algorithm therefore keeps only the first, the second and the last cube of a run. A vertex whose last member is
//! the second cube counts k − 2 times. n identical cubes take time linear in n. Cubes of mixed types in an order that
//! also mixes the types are processed in full, all pairs with n bits each.

use super::cube::{Cube, Range, face_in};
use super::mass::Mass;
use super::order::{ByIndex, Face};
use super::wide;

/// The type of a cube: for each axis no face at the point, the lower one, or the upper one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Type([Option<bool>; 3]);

impl Type {
    fn of(lower: [i64; 3], edge: i64, cell: Range) -> Type {
        Type([0, 1, 2].map(|axis| face_in(lower[axis], edge, cell[axis])))
    }

    fn has(self, upper: bool) -> bool {
        self.0.contains(&Some(upper))
    }

    /// A number below 27 for the type.
    fn code(self) -> usize {
        self.0.iter().fold(0, |code, face| 3 * code + face.map_or(0, |upper| 1 + usize::from(upper)))
    }

    /// True if all faces of this type are also faces of the other type.
    fn is_part_of(self, other: Type) -> bool {
        (0..3).all(|axis| self.0[axis].is_none() || self.0[axis] == other.0[axis])
    }
}

/// A cube that is kept.
struct Kept {
    lower: [i64; 3],
    /// The cube's type, and the number of cubes of its run that it represents.
    kind: Type,
    times: u64,
}

/// Adds the vertices at a point.
///
/// `cubes` are all that reach the point, by descending index, that is by ascending p.
pub(super) fn add_crowd(cubes: &[Cube], edge: i64, cell: Range, mass: &mut Mass) {
    let mut kept = runs(&visible(cubes, edge, cell));
    // Of two neighbours in a run, the one with the larger p comes second.
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
        // The second cube of a run, unless the vertex also has the last one. (A vertex never has such cubes of two
        // runs.)
        let repeated = owners.iter().find(|&&owner| kept[owner].times > 1 && !owners.contains(&owner.wrapping_sub(1)));
        let times = repeated.map_or(1, |&owner| kept[owner].times);
        mass.add(owners, cell.map(|[from, _]| from), vertex.map(|face| face.upper), times);
    });
}

/// The cubes that are not contained in another cube near the point. (No cube covers the point.)
fn visible(cubes: &[Cube], edge: i64, cell: Range) -> Vec<Kept> {
    let kinds = || cubes.iter().map(|cube| Type::of(cube.lower, edge, cell));
    // For each type without upper faces the first cube, for each type without lower faces the last one.
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

/// Replaces each longer run by three cubes; the second represents all but the ends.
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
