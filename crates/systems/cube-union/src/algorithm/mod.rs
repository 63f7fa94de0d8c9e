//! Volume, surface area and edge length of the union of congruent axis-parallel cubes (Franklin & Magalhães, 4.3;
//! Franklin, "Mass properties of the union of millions of identical cubes", 2005).
//!
//! The union itself is never built. Its mass properties are sums over its vertices. The contribution of a vertex
//! depends only on its coordinates and the directions of its faces.
//!
//! # Perturbation
//! Cube i is moved by an infinitesimal, along all axes, that is larger than those of all cubes after it. So of two
//! equal coordinates, that of the cube with the smaller index is larger. Both faces of a cube move alike, so a cube
//! stays a cube. Then no two faces are in one plane, and the boundary has three kinds of vertices. They are the corners
//! of a cube, the points where an edge of one cube meets a face of another, and the points where faces of three cubes
//! meet. Each vertex is outside all other cubes. The results are the limits for perturbations that go to zero:
//! * The volume is that of the union; ties do not affect it.
//! * The area is that of the perturbed boundary. Suppose that the upper face of one cube lies on the lower face of
//!   another. If the first cube has the smaller index, they overlap by an infinitesimal, and the common part is not
//!   boundary. Otherwise there is a gap, and the common part is boundary on both sides.
//! * The edge length is that of the perturbed boundary, too. A seam between two faces in one plane counts twice: one
//!   face is a step above the other, and a step has two edges.
//!
//! # The formulas
//! Let f be 1 in the union and 0 elsewhere. Let c(v) be the sum of f over the eight octants around the point v, each
//! with the product of the octant's three directions (±1) as sign. It is the mixed derivative ∂x∂y∂z f, a sum of points
//! with weights c(v). It vanishes except at vertices, as f doesn't depend on all three coordinates elsewhere.
//! Integration by parts, once for each axis, gives
//!
//! > volume = ∫ f = −Σ c(v) x y z.
//!
//! At a vertex let s = (s₁, s₂, s₃) be the directions of its x, y and z face, +1 for the upper face of a cube. Around a
//! corner f is the product h₁h₂h₃ of three half-spaces, hᵢ on the side −sᵢ, and c = −s₁s₂s₃. At an edge and a face,
//! f = 1 − (1 − h₁h₂)(1 − h₃), of which only −h₁h₂h₃ depends on all coordinates: c has the other sign. Three faces have
//! f = 1 − (1 − h₁)(1 − h₂)(1 − h₃) and c as at a corner. With t = −1 at an edge and a face, and t = 1 elsewhere,
//! c = −t s₁s₂s₃ and
//!
//! > volume = Σ t (s₁x)(s₂y)(s₃z).
//!
//! **Area.** In a plane x = const there is one face, and its direction is s₁ everywhere. So it is boundary where
//! f(x−) − f(x+) is s₁, and not where it is 0. By parts in the plane, its area is Σ d(v) y z. Here d(v) is the sum over
//! quadrants of s₁(f(x−) − f(x+)) with their signs, which is −s₁c(v) = t s₂s₃. So
//!
//! > area = Σ t ((s₁x)(s₂y) + (s₂y)(s₃z) + (s₃z)(s₁x)).
//!
//! **Edge length.** On a line along z through an x face and a y face, the boundary has an edge wherever the sum over
//! the four quadrants around the line doesn't vanish. The sum there is s₁s₂ if both faces are of one cube (a convex
//! edge) and −s₁s₂ if they are of two (a reflex edge). Call this sign κ₃. Crossing v along z, the sum changes by c(v),
//! so the length of the line's edges is −Σ κ₃s₁s₂ c(v) z = Σ t κ₃ s₃z. Over all axes,
//!
//! > length = Σ t (κ₁s₁x + κ₂s₂y + κ₃s₃z),
//!
//! where all κ are 1 at a corner and −1 at three faces; where an edge meets a face, κ is 1 along that edge and −1 along
//! the other two axes.
//!
//! # Finding the vertices
//! Cubes are sorted into a uniform grid by their lower corners (`bins`); the denser the cubes, the smaller the cells.
//! Each cell is searched separately for its vertices. Franklin's covered cells are skipped: a cell within a cube has no
//! vertices. For most of them the grid shows this without a look at any cube. A crowded cell is divided into eight, and
//! those into eight again, with the same steps. So cells get smaller where cubes are dense, and stay few elsewhere. In
//! the remaining cells, triples of faces come from bit sets (`cell`). Cells do not depend on each other: they are
//! mapped in parallel and the sums reduced.
//!
//! The time is linear for evenly spread cubes, and for any number of identical cubes. If a grid can't separate cubes,
//! hidden cubes and the inner cubes of a run of equal types are counted and not processed (`crowd`). The other n cubes
//! at a point share a coordinate on each axis, in different corners and in an order that mixes them. They are processed
//! by pairs, with n bits each: time grows with n³, with a small constant, and memory with n².
//!
//! # The source of comparisons
//! [`cube_union`] compares integers and breaks ties itself. [`cube_union_by`] asks a session instead, and
//! [`union_in_order`] takes any [`Order`]. Both process every pair of cubes, as an inconsistent order does not allow
//! sorting.
//!
//! # Ties that stay ties
//! A session that does not break ties compares two faces in one plane as equal. At the first such answer
//! [`cube_union_by`] goes over to the union of the cubes as closed sets (`touching`): faces in one plane are one plane,
//! and the octants around a point say what it contributes, by one table of 22 cases. A union in general position has
//! three of them and never enters the table.
//!
//! # Exactness
//! Coordinates are integers, or [scaled](ScaledCubes) to integers without rounding, and all sums are exact.
//!
//! ```
//! # use predicament_cube_union::algorithm::cube_union;
//! // Two cubes of edge 2 with a corner in each other.
//! let mass = cube_union(&[[0, 0, 0], [1, 1, 1]], 2)?;
//! assert_eq!((mass.volume, mass.area, mass.edge_length), (15, 42, 48));
//! // Seven corners of each, and six points where an edge meets a face.
//! let vertices = mass.vertices;
//! assert_eq!((vertices.corners, vertices.edge_faces, vertices.three_faces), (14, 6, 0));
//! assert_eq!(vertices.euler_characteristic(), Some(2));
//! # Ok::<(), predicament_cube_union::algorithm::CubesError>(())
//! ```

mod bins;
mod cell;
mod coordinate;
mod crowd;
mod cube;
mod error;
mod mass;
mod order;
mod scaled;
mod touching;
mod wide;

use predicament_predicates::{PredicateKind, Predicates};
use rayon::prelude::*;

use bins::{Bins, Entry};
use cell::{Scratch, add_cell, is_covered};
pub use coordinate::Coordinate;
use cube::{Cube, reaches};
pub use error::CubesError;
pub use mass::{Mass, Vertices};
pub use order::{ByIndex, BySession, Face, Order};
pub use scaled::ScaledCubes;
pub use touching::TIED;

/// The number of cells that one task processes.
const CELLS: usize = 1 << 12;

/// The mass properties of the union of cubes, by their lower corners and the length of their edges, in parallel.
///
/// Besides the input it takes 16 bytes for each cube if coordinates are `i32`, 32 if they are `i64`, and 4 for each
/// cell; there are at most two cells for each cube. During sorting, the cubes of a block of cells are in memory twice:
/// few, unless all cubes are in few places.
///
/// # Errors
/// [`CubesError`] if the edge length is not positive, or exact sums can't hold the number or the distance of the cubes.
pub fn cube_union<C: Coordinate>(lowers: &[[C; 3]], edge: C) -> Result<Mass, CubesError> {
    let length = positive(edge.into())?;
    if u32::try_from(lowers.len()).is_err() {
        return Err(CubesError::TooMany { cubes: lowers.len() });
    }
    if lowers.is_empty() {
        return Ok(Mass::default());
    }
    let (least, extents) = bounds(lowers, length)?;
    let bins = Bins::new(lowers, least, extents, length.cast_unsigned());
    let size = bins.cell.cast_signed();
    let is_tight = bins.is_tight(length.cast_unsigned());
    let starts: Vec<usize> = (0..bins.cells()).step_by(CELLS).collect();
    let sums = starts.into_par_iter().map_init(
        || (Vec::new(), Scratch::new()),
        |(cubes, scratch), first| {
            let mut mass = Mass::default();
            for id in first..bins.cells().min(first + CELLS) {
                let place = bins.place(id);
                if bins.is_covered(id, place) {
                    continue;
                }
                let cell = place.map(|at| {
                    let from = at as i64 * size;
                    [from, from + size]
                });
                cubes.clear();
                bins.near(id, place, |entry| cubes.push(cube(entry)));
                if !is_tight {
                    cubes.retain(|cube| reaches(cube.lower, length, cell));
                }
                if size == length || !is_covered(cubes, length, cell) {
                    add_cell(cubes, 0, length, cell, scratch, &mut mass);
                }
            }
            mass
        },
    );
    Ok(sums.reduce(Mass::default, Mass::merge))
}

/// The cube of an entry. (Extents are below 2^62.)
#[inline]
fn cube<R: Copy + Into<u64>>(entry: &Entry<R>) -> Cube {
    Cube { lower: entry.lower.map(|c| c.into().cast_signed()), index: entry.index }
}

#[allow(clippy::cast_precision_loss)] // for the message only
fn positive(edge: i64) -> Result<i64, CubesError> {
    if edge > 0 { Ok(edge) } else { Err(CubesError::Edge { edge: edge as f64 }) }
}

/// The lower corner and the extents of the bounding box of all cubes; there is at least one cube.
fn bounds<C: Coordinate>(lowers: &[[C; 3]], edge: i64) -> Result<([C; 3], [u64; 3]), CubesError> {
    let join = |[least, most]: [[C; 3]; 2], [a, b]: [[C; 3]; 2]| {
        let pick = |axis: usize| (least[axis].min(a[axis]), most[axis].max(b[axis]));
        let [x, y, z] = [0, 1, 2].map(pick);
        [[x.0, y.0, z.0], [x.1, y.1, z.1]]
    };
    let first = [lowers[0]; 2];
    let [least, most] = lowers.par_iter().map(|&lower| [lower, lower]).reduce(|| first, join);
    let extents = [0, 1, 2].map(|axis| {
        let offset: u64 = most[axis].offset(least[axis]).into();
        u128::from(offset) + u128::from(edge.unsigned_abs())
    });
    let volume = extents[0].checked_mul(extents[1]).and_then(|area| area.checked_mul(extents[2]));
    let holds = extents.iter().all(|&extent| extent < 1 << 62) && volume.is_some_and(|volume| volume < 1 << 127);
    if !holds {
        return Err(CubesError::TooLarge { extents });
    }
    // (below 2^62)
    Ok((least, extents.map(|extent| u64::try_from(extent).unwrap_or_else(|_| unreachable!("checked")))))
}

/// The mass properties of the union of a scene's cubes, by the session's comparisons, and the exponent of their unit:
/// volumes are multiples of (2^exponent)³.
///
/// Vertex 2i of the scene is the lower corner of cube i and vertex 2i + 1 its upper corner. Sessions with exact signs
/// for perturbed points agree with [`cube_union`]. If two faces of two cubes compare as equal, the result is the union
/// of closed cubes. If a zero does not mean zero, faces merge that the session doesn't tell apart.
///
/// Time and memory grow with the square of the number of cubes.
///
/// # Errors
/// [`CubesError`] if the session doesn't compare coordinates, or the scene doesn't consist of congruent cubes, or exact
/// sums can't hold its cubes.
pub fn cube_union_by<S: Predicates>(session: &S) -> Result<(Mass, i32), CubesError> {
    session.supports(PredicateKind::Compare).map_err(CubesError::Declined)?;
    let cubes = ScaledCubes::of_scene(session.scene())?;
    Ok((union_in_order(&BySession(session), &cubes.lowers, cubes.edge)?, cubes.exponent))
}

/// The mass properties of the union of cubes for any order of their faces: of closed cubes, if faces of two cubes
/// compare as equal.
///
/// # Errors
/// Like [`cube_union`].
pub fn union_in_order<O: Order>(order: &O, lowers: &[[i64; 3]], edge: i64) -> Result<Mass, CubesError> {
    positive(edge)?;
    let Ok(count) = u32::try_from(lowers.len()) else {
        return Err(CubesError::TooMany { cubes: lowers.len() });
    };
    if lowers.is_empty() {
        return Ok(Mass::default());
    }
    let (least, _) = bounds(lowers, edge)?;
    let faces: Vec<Face> = (0..count).flat_map(|cube| [false, true].map(|upper| Face { cube, upper })).collect();
    let mut mass = Mass::default();
    let is_general = wide::vertices(order, count, [&faces, &faces, &faces], |vertex| {
        let at = [0, 1, 2].map(|axis| {
            let Face { cube, upper } = vertex[axis];
            lowers[cube as usize][axis] - least[axis] + if upper { edge } else { 0 }
        });
        mass.add(vertex.map(|face| face.cube as usize), at, vertex.map(|face| face.upper), 1);
    });
    Ok(if is_general { mass } else { touching::union(order, count, lowers, edge, least) })
}
