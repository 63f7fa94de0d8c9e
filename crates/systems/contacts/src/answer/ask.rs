//! The query of a session about one pair of simplices.

use predicament_mesh::{Complex, Simplex};
use predicament_predicates::Predicates;

use super::{Contact, Weights};

/// The contact of a pair, if the session registers it; sub-pairs are not considered.
///
/// The query is the one for the pair's ranks, the simplex of higher rank first; of two edges, the one with the lower
/// vertices first.
///
/// # Panics
/// If the hierarchy does not have pairs of these ranks.
pub fn ask<S: Predicates + ?Sized>(session: &S, [a, b]: [&Complex; 2], [s, t]: [Simplex; 2]) -> Option<Contact> {
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
