//! The hierarchy by brute force: every pair is tested, boxes and reach are not used, and sub-pairs are found by trying
//! all vertex subsets.

use std::collections::{BTreeMap, HashSet};

use predicament_mesh::Complex;
use predicament_predicates::{Predicates, Vertex};

use super::faces::{Cell, faces};

/// Weights by vertex.
pub type Where = BTreeMap<Vertex, f64>;

/// A registered pair by its vertices.
#[derive(Clone, PartialEq, PartialOrd, Debug)]
pub struct Pair {
    pub a: Cell,
    pub b: Cell,
    pub on_a: Where,
    pub on_b: Where,
}

/// The numbers of pairs of two ranks, by outcome: without boxes every pair is a candidate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Count {
    pub ranks: [u8; 2],
    pub ended: u64,
    pub asked: u64,
    pub registered: u64,
}

/// All simplices of the complex with this number of vertices.
pub fn cells(complex: &Complex, vertices: usize) -> Vec<Cell> {
    match vertices {
        1 => complex.vertices().iter().map(|&v| vec![v]).collect(),
        2 => complex.edges().iter().map(|s| s.to_vec()).collect(),
        3 => complex.triangles().iter().map(|s| s.to_vec()).collect(),
        _ => complex.tetrahedra().iter().map(|s| s.to_vec()).collect(),
    }
}

fn weights<const N: usize>(cell: [Vertex; N], weights: [f64; N]) -> Where {
    cell.into_iter().zip(weights).collect()
}

fn along(edge: [Vertex; 2], fraction: f64) -> Where {
    weights(edge, [1.0 - fraction, fraction])
}

/// The answer to the query about one pair, the larger simplex first.
fn ask<S: Predicates>(session: &S, large: &[Vertex], small: &[Vertex]) -> Option<(Where, Where)> {
    Some(match (large, small) {
        (&[p], &[q]) => {
            session.vertex_vertex(p.min(q), p.max(q)).then(|| (weights([p], [1.0]), weights([q], [1.0])))?
        }
        (&[a, b], &[p]) => (along([a, b], session.edge_vertex([a, b], p)?), weights([p], [1.0])),
        (&[a, b], &[p, q]) if [a, b] <= [p, q] => {
            let [s, t] = session.edge_edge([a, b], [p, q])?;
            (along([a, b], s), along([p, q], t))
        }
        (&[_, _], &[_, _]) => ask(session, small, large).map(|(on_small, on_large)| (on_large, on_small))?,
        (&[a, b, c], &[p]) => (weights([a, b, c], session.triangle_vertex([a, b, c], p)?), weights([p], [1.0])),
        (&[a, b, c], &[p, q]) => {
            let (on, fraction) = session.triangle_edge([a, b, c], [p, q])?;
            (weights([a, b, c], on), along([p, q], fraction))
        }
        (&[a, b, c, d], &[p]) => {
            (weights([a, b, c, d], session.tetrahedron_vertex([a, b, c, d], p)?), weights([p], [1.0]))
        }
        _ => unreachable!(),
    })
}

/// All registered pairs, level by level, and the counts of each level.
pub fn brute_force<S: Predicates>(session: &S, a: &Complex, b: &Complex) -> (Vec<Pair>, Vec<Count>) {
    let (mut all, mut counts) = (Vec::new(), Vec::new());
    let mut registered: HashSet<(Cell, Cell)> = HashSet::new();
    for level in 2..=session.scene().dimension().count() + 2 {
        let mut found = Vec::new();
        for of_a in 1..level {
            let rank = |vertices: usize| u8::try_from(vertices - 1).unwrap();
            let ranks = [rank(of_a), rank(level - of_a)];
            let mut count = Count { ranks, ended: 0, asked: 0, registered: 0 };
            for s in cells(a, of_a) {
                for t in cells(b, level - of_a) {
                    let subs = faces(&t);
                    let has = |s: &Cell| subs.iter().any(|t| registered.contains(&(s.clone(), t.clone())));
                    if faces(&s).iter().any(has) {
                        count.ended += 1;
                        continue;
                    }
                    count.asked += 1;
                    let answer = if s.len() >= t.len() {
                        ask(session, &s, &t)
                    } else {
                        ask(session, &t, &s).map(|(on_b, on_a)| (on_a, on_b))
                    };
                    if let Some((on_a, on_b)) = answer {
                        count.registered += 1;
                        found.push(Pair { a: s.clone(), b: t, on_a, on_b });
                    }
                }
            }
            counts.push(count);
        }
        registered.extend(found.iter().map(|pair| (pair.a.clone(), pair.b.clone())));
        all.extend(found);
    }
    (all, counts)
}
