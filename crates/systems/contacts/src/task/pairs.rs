//! Pairs of simplices: sets of them, their sub-pairs, and their names.

use std::collections::BTreeSet;

use predicament_mesh::{Complex, Faces, Simplices};
use predicament_predicates::{Dimension, Scene, Vertex};

use crate::truth::Pair;
use predicament_tasks::ids;

/// Registered pairs of two complexes.
pub(crate) struct Pairs<'a> {
    complexes: [&'a Complex; 2],
    faces: &'a [Faces; 2],
    set: BTreeSet<Pair>,
}

impl<'a> Pairs<'a> {
    pub fn new(complexes: [&'a Complex; 2], faces: &'a [Faces; 2], set: BTreeSet<Pair>) -> Pairs<'a> {
        Pairs { complexes, faces, set }
    }

    pub fn contains(&self, pair: Pair) -> bool {
        self.set.contains(&pair)
    }

    pub fn iter(&self) -> impl Iterator<Item = Pair> {
        self.set.iter().copied()
    }

    /// A registered pair of faces that ended this pair, if any.
    pub fn ended_by(&self, [s, t]: Pair) -> Option<Pair> {
        let [of_s, of_t] = self.faces;
        let mut pairs = of_s.of(s).flat_map(|s| of_t.of(t).map(move |t| [s, t]));
        pairs.find(|&pair| pair != [s, t] && self.contains(pair))
    }

    /// A pair's state in words: registered, ended by another, or neither.
    pub fn say(&self, pair: Pair) -> String {
        match self.ended_by(pair) {
            _ if self.contains(pair) => "registered".to_owned(),
            Some(other) => format!("ended by ({})", name(self.complexes, other)),
            None => "apart".to_owned(),
        }
    }
}

/// A simplex and its faces, as a separate complex.
pub(crate) fn closure(scene: &Scene, simplex: &[Vertex]) -> Complex {
    let mut given = Simplices::default();
    match *simplex {
        [a] => given.vertices.push(a),
        [a, b] => given.edges.push([a, b]),
        [a, b, c] => given.triangles.push([a, b, c]),
        [a, b, c, d] => given.tetrahedra.push([a, b, c, d]),
        _ => unreachable!("a simplex has one to four vertices"),
    }
    Complex::new(scene, &given).expect("a simplex of the scene")
}

/// The vertices of a pair: `0 1, 4 5`.
pub(crate) fn name([a, b]: [&Complex; 2], [s, t]: Pair) -> String {
    format!("{}, {}", ids(a.vertices_of(s)), ids(b.vertices_of(t)))
}

/// True if the ranks of a pair add up to less than the dimension; pairs in general position meet only on the last
/// level.
pub(crate) fn is_degenerate(dimension: Dimension, [s, t]: Pair) -> bool {
    usize::from(s.rank) + usize::from(t.rank) < dimension.count()
}
