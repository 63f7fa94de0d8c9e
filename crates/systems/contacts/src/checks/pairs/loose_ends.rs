//! The check that the intersection curves of two closed surfaces have no loose ends.

use crate::answer::Contacts;
use crate::answer::{Arrangement, Side};
use predicament_mesh::Complex;
use predicament_predicates::Vertex;

use super::NotOriented;
use super::orient::triangle_degrees;

/// A point where an edge of one surface pierces a triangle of the other, and where no curve continues in one of the
/// edge's triangles.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct LooseEnd {
    /// The point of the arrangement.
    pub point: usize,
    /// The triangle of each complex.
    pub triangles: [u32; 2],
    /// The number of other points that the two triangles have in common. One would be right: with none the curve does
    /// not continue, with more its direction is not determined.
    pub others: usize,
}

/// The piercings of two surfaces, and the loose ends of their curves.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct LooseEnds {
    /// The number of registered piercings of triangles by edges.
    pub piercings: usize,
    /// The number of pieces of intersection curves.
    pub pieces: usize,
    /// The number of pairs of triangles with more than two points in common: they overlap, and do not define a curve.
    pub overlaps: usize,
    /// The loose ends, in order.
    pub loose: Vec<LooseEnd>,
}

/// Follows the intersection curves of two closed surfaces through each piercing.
///
/// If an edge pierces a triangle, each of the edge's triangles has a piece of curve that begins there. It ends in one
/// other point that both triangles have: another piercing, or a merged degeneracy. (The intersection of two triangles
/// that are not in one plane is a segment, and between its ends there is no point of the boundary of either. With exact
/// signs, a pierced triangle has area. A triangle of the edge without area is a segment, and its boundary passes
/// through each of its points twice.) In a closed surface an edge has two triangles, so a piercing is the end of two
/// pieces. The law holds through degeneracies. At a merged point itself any number of pieces can meet, and surfaces
/// that touch can share a piece with loose ends.
///
/// # Errors
/// [`NotOriented::Border`] if an edge of a surface has an odd number of triangles.
///
/// # Panics
/// If the arrangement was not made from these complexes and contacts.
pub fn loose_ends(
    complexes: [&Complex; 2],
    contacts: &Contacts,
    arrangement: &Arrangement,
) -> Result<LooseEnds, NotOriented> {
    for (side, complex) in Side::BOTH.into_iter().zip(complexes) {
        let odd = |&(_, degree): &(_, usize)| !degree.is_multiple_of(2);
        if let Some((edge, degree)) = triangle_degrees(complex).into_iter().find(odd) {
            return Err(NotOriented::Border { side, edge, degree });
        }
    }
    let intersection = arrangement.intersection(complexes, contacts);
    let mut ends =
        LooseEnds { pieces: intersection.pieces().len(), overlaps: intersection.overlaps(), ..LooseEnds::default() };
    let around = complexes.map(triangles_around);
    for (contact, &point) in contacts.registered.iter().zip(arrangement.of_contacts()) {
        let pairs: Vec<[u32; 2]> = match [contact.a.rank, contact.b.rank] {
            [1, 2] => around[0][contact.a.index as usize].iter().map(|&s| [s, contact.b.index]).collect(),
            [2, 1] => around[1][contact.b.index as usize].iter().map(|&t| [contact.a.index, t]).collect(),
            _ => continue,
        };
        ends.piercings += 1;
        for triangles in pairs {
            let points = intersection.of(triangles).map_or(&[][..], |meeting| &meeting.points);
            let others = points.iter().filter(|&&other| other != point).count();
            if others != 1 {
                ends.loose.push(LooseEnd { point, triangles, others });
            }
        }
    }
    ends.loose.sort_unstable();
    Ok(ends)
}

/// The triangles of each edge.
fn triangles_around(complex: &Complex) -> Vec<Vec<u32>> {
    let mut around = vec![Vec::new(); complex.edges().len()];
    let place = |edge: &[Vertex; 2]| complex.edges().binary_search(edge).expect("a triangle's edges are there");
    for (index, &[a, b, c]) in (0_u32..).zip(complex.triangles()) {
        for edge in [[a, b], [a, c], [b, c]] {
            around[place(&edge)].push(index);
        }
    }
    around
}
