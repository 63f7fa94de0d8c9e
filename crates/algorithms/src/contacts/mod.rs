//! Contacts between two complexes: which pairs of simplices meet, the most
//! degenerate first.
//!
//! Wang, Jiang, Schroeder and Teran register degeneracies in a hierarchy: first
//! vertices with vertices, then vertices with edges, and so on to the pairs
//! whose dimensions add up to that of the space. A pair of which a sub-pair (a
//! face of the one with a face of the other) is registered has ended and is not
//! asked about: what meets in a common vertex does not meet again in an edge.
//! So each question may assume that nothing more degenerate is there, which is
//! what makes it safe to ask in floating point.
//!
//! The driver is the same for every philosophy: with exact signs it sorts the
//! common points of two closed complexes by their carriers, with perturbed
//! signs only pairs of the last level can register, with tolerances it is the
//! paper's scheme.

use std::collections::HashSet;

use predicament_mesh::{Complex, Simplex};
use predicament_predicates::{Dimension, Predicates};

/// Barycentric coordinates of a point in a simplex, one for each of its
/// vertices in ascending order; those that the simplex lacks are zero.
pub type Weights = [f64; 4];

/// A registered pair: a simplex of each complex, and where on it they meet.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Contact {
    /// The simplex of the first complex.
    pub a: Simplex,
    /// The simplex of the second complex.
    pub b: Simplex,
    /// Where on the first.
    pub on_a: Weights,
    /// Where on the second.
    pub on_b: Weights,
}

/// All registered pairs, by level (the sum of the ranks), then by simplices.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Contacts {
    /// The registered pairs.
    pub registered: Vec<Contact>,
}

/// The ranks of the pairs of each level, level after level.
#[must_use]
pub fn levels(dimension: Dimension) -> &'static [&'static [[u8; 2]]] {
    const LEVELS: [&[[u8; 2]]; 4] =
        [&[[0, 0]], &[[0, 1], [1, 0]], &[[0, 2], [1, 1], [2, 0]], &[[0, 3], [1, 2], [2, 1], [3, 0]]];
    &LEVELS[..=dimension.count()]
}

/// The contacts of two complexes of the session's scene.
///
/// # Panics
/// If the session doesn't [support](Predicates::supports_contacts) contacts.
#[must_use]
pub fn contacts<S: Predicates>(session: &S, a: &Complex, b: &Complex) -> Contacts {
    let mut registered = Contacts::default();
    let mut ended: HashSet<[Simplex; 2]> = HashSet::new();
    for pairs in levels(session.scene().dimension()) {
        let mut level = Vec::new();
        for &[rank_a, rank_b] in *pairs {
            for s in simplices(a, rank_a) {
                for t in simplices(b, rank_b) {
                    if has_registered_faces(&ended, [a, b], [s, t]) {
                        continue;
                    }
                    level.extend(ask(session, [a, b], [s, t]));
                }
            }
        }
        level.sort_unstable_by_key(|contact: &Contact| (contact.a, contact.b));
        ended.extend(level.iter().map(|contact| [contact.a, contact.b]));
        registered.registered.extend(level);
    }
    registered
}

fn simplices(complex: &Complex, rank: u8) -> impl Iterator<Item = Simplex> + use<> {
    let count = match rank {
        0 => complex.vertices().len(),
        1 => complex.edges().len(),
        2 => complex.triangles().len(),
        _ => complex.tetrahedra().len(),
    };
    (0..count).map(move |index| Simplex { rank, index: u32::try_from(index).expect("a complex holds 2^32 at most") })
}

fn has_registered_faces(ended: &HashSet<[Simplex; 2]>, [a, b]: [&Complex; 2], [s, t]: [Simplex; 2]) -> bool {
    let faces = |complex: &Complex, simplex: Simplex| -> Vec<Simplex> {
        let vertices = complex.vertices_of(simplex);
        (1_u32..1 << vertices.len())
            .map(|subset| {
                let face: Vec<_> =
                    vertices.iter().enumerate().filter(|(i, _)| subset >> i & 1 == 1).map(|(_, &v)| v).collect();
                complex.find(&face).expect("a complex has the faces of its simplices")
            })
            .collect()
    };
    let of_t = faces(b, t);
    faces(a, s).iter().any(|&s| of_t.iter().any(|&t| ended.contains(&[s, t])))
}

/// Asks the question of the pair's ranks, the simplex of higher rank first; of
/// two edges the one with the lower vertices.
fn ask<S: Predicates>(session: &S, [a, b]: [&Complex; 2], [s, t]: [Simplex; 2]) -> Option<Contact> {
    let (on_a, on_b) = match (a.vertices_of(s), b.vertices_of(t)) {
        (&[p], &[q]) => session.vertex_vertex(p.min(q), p.max(q)).then_some((pad([1.0]), pad([1.0])))?,
        (&[e, f], &[p]) => (along(session.edge_vertex([e, f], p)?), pad([1.0])),
        (&[p], &[e, f]) => (pad([1.0]), along(session.edge_vertex([e, f], p)?)),
        (&[c, d], &[e, f]) => {
            let flip = [c, d] > [e, f];
            let [first, second] = if flip { [[e, f], [c, d]] } else { [[c, d], [e, f]] };
            let [on_first, on_second] = session.edge_edge(first, second)?.map(along);
            if flip { (on_second, on_first) } else { (on_first, on_second) }
        }
        (&[c, d, e], &[p]) => (pad(session.triangle_vertex([c, d, e], p)?), pad([1.0])),
        (&[p], &[c, d, e]) => (pad([1.0]), pad(session.triangle_vertex([c, d, e], p)?)),
        (&[c, d, e], &[p, q]) => {
            let (on_triangle, on_edge) = session.triangle_edge([c, d, e], [p, q])?;
            (pad(on_triangle), along(on_edge))
        }
        (&[p, q], &[c, d, e]) => {
            let (on_triangle, on_edge) = session.triangle_edge([c, d, e], [p, q])?;
            (along(on_edge), pad(on_triangle))
        }
        (&[c, d, e, f], &[p]) => (pad(session.tetrahedron_vertex([c, d, e, f], p)?), pad([1.0])),
        (&[p], &[c, d, e, f]) => (pad([1.0]), pad(session.tetrahedron_vertex([c, d, e, f], p)?)),
        (s, t) => unreachable!("no pair of {} and {} vertices in any hierarchy", s.len(), t.len()),
    };
    Some(Contact { a: s, b: t, on_a, on_b })
}

fn pad<const N: usize>(weights: [f64; N]) -> Weights {
    std::array::from_fn(|i| weights.get(i).copied().unwrap_or(0.0))
}

fn along(fraction: f64) -> Weights {
    [1.0 - fraction, fraction, 0.0, 0.0]
}
