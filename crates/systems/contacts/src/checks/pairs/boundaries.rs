//! The check that the boundary of a triangle pierces a closed surface an even number of times.

use std::collections::BTreeSet;

use crate::answer::Contacts;
use crate::answer::Side;
use predicament_mesh::{Complex, Simplex};

use super::NotOriented;
use super::orient::triangle_degrees;

/// The numbers of triangle boundaries of two surfaces, by the parity of their piercings.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Boundaries {
    /// Boundaries to which the law applies: all registered contacts are piercings, and there is at least one.
    pub checked: usize,
    /// Boundaries with a degenerate contact. Its effect on the count depends on the locations of merged points and on
    /// the division of their triangles.
    pub degenerate: usize,
    /// Triangles whose boundary pierces the other surface an odd number of times, in order.
    pub odd: Vec<(Side, u32)>,
}

/// Counts the registered piercings of each surface by the boundary of every triangle of the other one.
///
/// The three edges of a triangle are a closed curve, which passes through a closed surface an even number of times. If
/// the number is odd, a curve of intersection enters the triangle and does not leave it, so
/// [`loose_ends`](super::loose_ends) finds it too. The converse does not hold, as a curve can also be broken off within
/// a triangle.
///
/// # Errors
/// [`NotOriented::Border`] if an edge of a surface has an odd number of triangles.
pub fn boundaries(complexes: [&Complex; 2], contacts: &Contacts) -> Result<Boundaries, NotOriented> {
    for (side, complex) in Side::BOTH.into_iter().zip(complexes) {
        let odd = |&(_, degree): &(_, usize)| !degree.is_multiple_of(2);
        if let Some((edge, degree)) = triangle_degrees(complex).into_iter().find(odd) {
            return Err(NotOriented::Border { side, edge, degree });
        }
    }
    let mut found = Boundaries::default();
    for (side, complex) in Side::BOTH.into_iter().zip(complexes) {
        let mut piercings = vec![0_usize; complex.edges().len()];
        let mut degenerate: BTreeSet<Simplex> = BTreeSet::new();
        for contact in &contacts.registered {
            let [own, other] = if side == Side::A { [contact.a, contact.b] } else { [contact.b, contact.a] };
            match [own.rank, other.rank] {
                [1, 2] => piercings[own.index as usize] += 1,
                [0 | 1, _] => {
                    degenerate.insert(own);
                }
                _ => {}
            }
        }
        for (index, &[a, b, c]) in (0_u32..).zip(complex.triangles()) {
            let find = |face: &[_]| complex.find(face).expect("a complex has the faces of its simplices");
            let edges = [[a, b], [a, c], [b, c]].map(|edge| find(&edge));
            let count: usize = edges.iter().map(|edge| piercings[edge.index as usize]).sum();
            let corners = [a, b, c].map(|corner| find(&[corner]));
            if edges.iter().chain(&corners).any(|face| degenerate.contains(face)) {
                found.degenerate += 1;
            } else if count > 0 {
                found.checked += 1;
                if !count.is_multiple_of(2) {
                    found.odd.push((side, index));
                }
            }
        }
    }
    Ok(found)
}
