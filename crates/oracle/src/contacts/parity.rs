//! Topology that needs the contacts and nothing else: closed curves cross an
//! even number of times.
//!
//! In the plane that is the edges of one complex against those of the other,
//! where both are closed. In space it is the boundary of each triangle against
//! the other complex, where that is a closed surface. Crossings count only if
//! nothing degenerate is registered: then they are all that there is.

use std::collections::BTreeMap;

use predicament_mesh::{Complex, Simplex};
use predicament_predicates::{Dimension, Vertex};

use super::pairs::{Pair, Pairs, is_degenerate};
use crate::outcome::ids;

/// The odd counts, in words.
pub(crate) fn odd(dimension: Dimension, complexes: [&Complex; 2], got: &Pairs) -> Vec<String> {
    if got.iter().any(|pair| is_degenerate(dimension, pair)) {
        return Vec::new();
    }
    match dimension {
        Dimension::Two => curves(complexes, got),
        Dimension::Three => {
            let swapped: Vec<Pair> = got.iter().map(|[s, t]| [t, s]).collect();
            let [a, b] = complexes;
            let straight: Vec<Pair> = got.iter().collect();
            [triangles(a, b, &straight), triangles(b, a, &swapped)].concat()
        }
    }
}

fn curves([a, b]: [&Complex; 2], got: &Pairs) -> Vec<String> {
    let crossings = got.iter().filter(|[s, t]| (s.rank, t.rank) == (1, 1)).count();
    let odd = crossings % 2 == 1 && is_closed(a.edges().iter()) && is_closed(b.edges().iter());
    if odd { vec![format!("two closed curves cross {crossings} times")] } else { Vec::new() }
}

/// The boundaries of the triangles of `a` against the surface `b`.
fn triangles(a: &Complex, b: &Complex, got: &[Pair]) -> Vec<String> {
    let sides = b.triangles().iter().map(|&[p, q, r]| [[p, q], [p, r], [q, r]]);
    let mut around: BTreeMap<[Vertex; 2], usize> = BTreeMap::new();
    sides.flatten().for_each(|side| *around.entry(side).or_default() += 1);
    if around.values().any(|count| count % 2 == 1) {
        return Vec::new();
    }
    let mut crossings: BTreeMap<Simplex, usize> = BTreeMap::new();
    for [s, t] in got.iter().filter(|[s, t]| (s.rank, t.rank) == (1, 2)) {
        debug_assert!(t.rank == 2);
        *crossings.entry(*s).or_default() += 1;
    }
    let times = |edge: &[Vertex; 2]| a.find(edge).and_then(|edge| crossings.get(&edge)).copied().unwrap_or(0);
    let boundary = |&[p, q, r]: &[Vertex; 3]| [[p, q], [p, r], [q, r]].iter().map(times).sum::<usize>();
    a.triangles()
        .iter()
        .map(|triangle| (triangle, boundary(triangle)))
        .filter(|(_, count)| count % 2 == 1)
        .map(|(triangle, count)| {
            format!("the boundary of triangle {} crosses a closed surface {count} times", ids(triangle))
        })
        .collect()
}

/// Whether every vertex has an even number of edges.
fn is_closed<'e>(edges: impl Iterator<Item = &'e [Vertex; 2]>) -> bool {
    let mut ends: BTreeMap<Vertex, usize> = BTreeMap::new();
    edges.flatten().for_each(|&v| *ends.entry(v).or_default() += 1);
    ends.values().all(|count| count % 2 == 0)
}
