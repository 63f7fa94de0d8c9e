//! The union of closed cubes for comparisons whose zero means zero.
//!
//! # Definition
//! The union U of closed cubes is closed, and it is the closure of its interior: it is *regularised* as it is. Cubes
//! that touch have a point in common, so nothing separates them there.
//! * The volume is the volume of U.
//! * The area is the area of the boundary of U. The common part of the faces of two cubes is not boundary, except for
//!   its border. A set without an area in which U meets itself, such as a common edge of two cubes, adds nothing.
//! * The edges are the points of the boundary around which it is not flat. Their length counts each point once. A seam
//!   between two faces in one plane is flat: it is not an edge. An edge at which two cubes meet crosswise is one edge.
//! * The Euler characteristic is the characteristic of U. It is parts − tunnels + cavities, where parts that meet in a
//!   point are one part.
//!
//! # The table of cases
//! The planes of all faces divide the neighbourhood of a point into at most eight octants. A cube that contains the
//! point is, along each axis, on the lower side of the point's plane (its upper face is there), on the upper side, or
//! on both. So it fills one, two, four or eight octants: the point is on a corner, an edge, a face or inside. These
//! are all 27 relations of a point and a cube, and any number of cubes at the point fills a union of such octants.
//! The octants that are filled are a *pattern* of eight bits.
//!
//! There are 256 patterns. Turns and mirror images of a cube make 22 cases of them: the table in `cases`. A pattern
//! that is constant along an axis is outside, inside, a face, an edge, a reflex edge or two edges that cross: six
//! cases that are not vertices. The other 16 are the vertices. In general position there are three of them: a corner,
//! an edge and a face, three faces. The other 13 need faces in one plane. The table does not compile if a pattern has
//! two cases or is without a case. The table is therefore complete, however many cubes meet, and in whatever way.
//!
//! # The terms
//! Let f be 1 in U and 0 elsewhere. The sums over vertices are those of the [parent module](super#the-formulas),
//! without its assumption that each plane has the face of one cube:
//! * The term of the volume is −c xyz, where c is the sum of the octants' f with the products of their directions as
//!   signs.
//! * In a plane across x, g is 1 where f differs on both sides. The area is ∫ g = Σ a yz, where a is the sum of the
//!   four quarters' g with the products of their directions as signs.
//! * Along a line parallel to x, e is 1 where the pattern of the four quarters is an edge: one quarter, three, or two
//!   that are opposite. The length is ∫ e = Σ (e(x−) − e(x+)) x.
//! * The planes of all faces divide U into cubes, squares, edges and points. The Euler characteristic counts points and
//!   squares, minus edges and cubes. Share each cube among its eight corners, each square among its four, each edge
//!   among its two. Then the term of a point in the characteristic follows from its pattern, in eighths:
//!   8 − 4 (half-lines in U) + 2 (quarter planes in U) − (octants in U). It is zero for the six other cases, by the
//!   last property: in a pattern that is constant along an axis, what lies along the axis cancels what lies across.
//!
//! # Finding the vertices
//! `levels` sorts the faces along each axis; faces that compare as equal share a plane. These are the only queries,
//! n log n of them. A vertex is where a plane across x, a plane across y and a plane across z meet, each with a face
//! at the point. In each plane across x, the algorithm moves a line along z from each plane across y to the next
//! (`line`). If the line has points on faces across x and y that are not inside of cubes, it looks at the octants
//! around all points of the line.

mod cases;
mod levels;
mod line;

use predicament_predicates::Axis;

use super::mass::Mass;
use super::order::{Face, Order};
pub use cases::TIED;
use cases::{CASES, Case, GENERAL, TERMS, VERTICES};
use levels::Levels;
use line::Line;

/// The cases that are vertices, those of general position first.
pub(super) fn cases() -> impl Iterator<Item = &'static Case> {
    CASES[..VERTICES].iter()
}

/// The mass properties of the closed union. Coordinates are relative to `least`.
pub(super) fn union<O: Order>(order: &O, count: u32, lowers: &[[i64; 3]], edge: i64, least: [i64; 3]) -> Mass {
    let levels = [Axis::X, Axis::Y, Axis::Z].map(|axis| Levels::new(order, axis, count));
    let coordinates: [Vec<i64>; 3] = std::array::from_fn(|axis| {
        let at =
            |&Face { cube, upper }: &Face| lowers[cube as usize][axis] - least[axis] + if upper { edge } else { 0 };
        levels[axis].faces.iter().map(|faces| at(&faces[0])).collect()
    });
    let [x, y, z] = &levels;
    // An order that merges the faces of one cube leaves nothing of it.
    let solid: Vec<u32> = (0..count).filter(|&cube| levels.iter().all(|axis| axis.is_solid(cube))).collect();
    let sorted = |along: &Levels| [0, 1].map(|end| along.sorted(&solid, end));
    let [along_y, along_z] = [y, z].map(sorted);
    let mut line = Line::new(z);
    let mut mass = Mass::default();
    for a in 0..x.count() {
        let meets = |cube: &u32| x.meets(*cube, a);
        line.restart(along_z.each_ref().map(|cubes| cubes.iter().copied().filter(meets)));
        let [starts, ends] = along_y.each_ref().map(|cubes| cubes.iter().copied().filter(meets).collect::<Vec<u32>>());
        let is_through = |cube: u32| x.sides(cube, a) == 3;
        let owners: Vec<u32> = starts.iter().copied().filter(|&cube| !is_through(cube)).collect();
        let [mut starts, mut ends] = [&starts[..], &ends[..]];
        while let Some(&end) = ends.first() {
            let upper = y.of[end as usize][1];
            let b = starts.first().map_or(upper, |&start| y.of[start as usize][0].min(upper));
            let (starting, ending) = (y.take(&mut starts, 0, b), y.take(&mut ends, 1, b));
            starting.iter().for_each(|&cube| line.toggle(cube));
            ending.iter().filter(|cube| is_through(**cube)).for_each(|&cube| line.uncover(z, cube));
            // A vertex is on a face across x and on a face across y.
            let of_x = z.hull(owners.iter().filter(|&&cube| y.meets(cube, b)));
            let of_y = z.hull(starting.iter().chain(ending));
            let both = [of_x[0].max(of_y[0]), of_x[1].min(of_y[1])];
            if both[0] <= both[1] && !line.is_covered(both) {
                let quarters = |cube: u32| {
                    let along_y = y.sides(cube, b);
                    // Bits 0 and 1 are on the lower side along y, bits 2 and 3 on the upper one.
                    x.sides(cube, a) * (along_y & 1 | (along_y & 2) << 1)
                };
                line.sweep(z, quarters, |c, octants| {
                    let [x, y, z] = &coordinates;
                    add(&mut mass, octants, [x[a as usize], y[b as usize], z[c as usize]]);
                });
            }
            starting.iter().filter(|cube| is_through(**cube)).for_each(|&cube| line.cover(z, cube));
            ending.iter().for_each(|&cube| line.toggle(cube));
        }
    }
    mass
}

/// Adds the terms of a point. Sums wrap, as those of [`Mass::add`].
fn add(mass: &mut Mass, octants: u8, at: [i64; 3]) {
    let terms = &TERMS[usize::from(octants)];
    if terms.case >= VERTICES {
        return;
    }
    let [x, y, z] = at.map(i128::from);
    mass.volume = mass.volume.wrapping_add((x * y).wrapping_mul(z).wrapping_mul(terms.volume.into()));
    for (product, factor) in [y * z, z * x, x * y].into_iter().zip(terms.area) {
        mass.area = mass.area.wrapping_add(product.wrapping_mul(factor.into()));
    }
    for (coordinate, factor) in [x, y, z].into_iter().zip(terms.edges) {
        mass.edge_length += coordinate * i128::from(factor);
    }
    let of = &mut mass.vertices;
    let count = match terms.case {
        0 => &mut of.corners,
        1 => &mut of.edge_faces,
        2 => &mut of.three_faces,
        tied => &mut of.tied[tied - GENERAL],
    };
    *count += 1;
}
