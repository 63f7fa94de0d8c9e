//! The questions about pairs of features, as data: the algorithm asks them, and the judge decides bands by them.
//!
//! The algorithm asks the questions about crossings one by one, since the first signs mostly suffice (`pairs.rs`). Here
//! they are a list for the judge.

use predicament_predicates::{Axis, Dimension, Plane, PredicateKind, Question, Scene, Vertex};

use super::formulas::{Formulas, Ranks};
use crate::answer::Pair;

/// Questions with their vertices.
pub type Asked = Vec<(Question, Vec<Vertex>)>;

/// A pair as the formulas name it: the vertices of the smaller feature first.
struct Measured {
    ranks: Ranks,
    corners: Vec<Vertex>,
}

/// The pair as the formulas name it; `None` if the features of such a pair have no single nearest points, or if they
/// cross where they meet.
fn measured(dimension: Dimension, [first, second]: &Pair) -> Option<Measured> {
    let (small, large) = if first.rank() <= second.rank() { (first, second) } else { (second, first) };
    let ranks = match (small.rank(), large.rank()) {
        (0, 0) => Ranks::VertexVertex,
        (0, 1) => Ranks::VertexEdge,
        (0, 2) if dimension == Dimension::Three => Ranks::VertexFace,
        (1, 1) if dimension == Dimension::Three => Ranks::EdgeEdge,
        _ => return None,
    };
    Some(Measured { ranks, corners: [small.corners(), large.corners()].concat() })
}

/// True if a pair of these dimensions can be nearest.
#[must_use]
pub(super) fn is_measured(dimension: Dimension, pair: &Pair) -> bool {
    measured(dimension, pair).is_some()
}

/// The questions whose signs are positive if the nearest points of the lines or planes of both features are inside the
/// features.
#[must_use]
pub fn inside(scene: &Scene, pair: &Pair) -> Asked {
    let formulas = Formulas::of(scene.dimension());
    let Some(Measured { ranks, corners }) = measured(scene.dimension(), pair) else { return Vec::new() };
    let ahead = |a, b, p| (Question::Derived(formulas.ahead), vec![a, b, p]);
    match (ranks, &corners[..]) {
        (Ranks::VertexEdge, &[p, a, b]) => vec![ahead(a, b, p), ahead(b, a, p)],
        (Ranks::VertexFace, &[p, a, b, c]) => {
            let within = formulas.within.map(Question::Derived);
            let edges = [[a, b, c, p], [b, c, a, p], [c, a, b, p]];
            within.into_iter().flat_map(|within| edges.map(|args| (within, args.to_vec()))).collect()
        }
        (Ranks::EdgeEdge, &[a, b, c, d]) => {
            let foot = formulas.foot.map(Question::Derived);
            let ends = [[a, b, c, d], [b, a, c, d], [c, d, a, b], [d, c, a, b]];
            foot.into_iter().flat_map(|foot| ends.map(|args| (foot, args.to_vec()))).collect()
        }
        _ => Vec::new(),
    }
}

/// The questions whose signs are zero if the nearest points of a pair are one point.
#[must_use]
pub fn meeting(scene: &Scene, pair: &Pair) -> Asked {
    let dimension = scene.dimension();
    let corners = measured(dimension, pair).map(|measured| measured.corners).unwrap_or_default();
    let planes = if dimension == Dimension::Two { &[Plane::Xy][..] } else { &[Plane::Xy, Plane::Yz, Plane::Zx] };
    match corners[..] {
        [p, q] => {
            let axes = &[Axis::X, Axis::Y, Axis::Z][..dimension.count()];
            axes.iter().map(|&axis| (Question::Compare(axis), vec![p, q])).collect()
        }
        [p, a, b] => planes.iter().map(|&plane| (Question::Orient2d(plane), vec![a, b, p])).collect(),
        [_, _, _, _] => vec![(Question::Orient3d, corners)],
        _ => Vec::new(),
    }
}

/// The questions whose signs say that a pair crosses: two edges in the plane, or an edge and a triangle in space.
#[must_use]
pub fn crossing([first, second]: &Pair) -> Asked {
    let (small, large) = if first.rank() <= second.rank() { (first, second) } else { (second, first) };
    let turn = |args: [Vertex; 3]| (Question::Orient2d(Plane::Xy), args.to_vec());
    let side = |args: [Vertex; 4]| (Question::Orient3d, args.to_vec());
    match (small.corners(), large.corners()) {
        (&[p, q], &[a, b]) => [[a, b, p], [a, b, q], [p, q, a], [p, q, b]].map(turn).to_vec(),
        (&[p, q], &[a, b, c]) => {
            [[a, b, c, p], [a, b, c, q], [p, q, a, b], [p, q, b, c], [p, q, c, a]].map(side).to_vec()
        }
        _ => Vec::new(),
    }
}

/// The question whose sign is that of the squared distance of one pair minus that of the other, and true if the sign
/// turns. `None` if the pairs are equal.
#[must_use]
pub fn comparing(scene: &Scene, one: &Pair, other: &Pair) -> Option<(Question, Vec<Vertex>, bool)> {
    if one == other {
        return None;
    }
    let [one, other] = [measured(scene.dimension(), one)?, measured(scene.dimension(), other)?];
    let turns = one.ranks > other.ranks;
    let [first, second] = if turns { [other, one] } else { [one, other] };
    let derived = Formulas::of(scene.dimension()).comparison(first.ranks, second.ranks)?;
    Some((Question::Derived(derived), [first.corners, second.corners].concat(), turns))
}

/// The predicates that the algorithm asks for.
#[must_use]
pub fn asks(dimension: Dimension) -> Vec<PredicateKind> {
    let side = (dimension == Dimension::Three).then_some(PredicateKind::Orient3d);
    let signs = [PredicateKind::Compare, PredicateKind::Orient2d].into_iter().chain(side);
    signs.chain(Formulas::of(dimension).all().map(PredicateKind::Derived)).collect()
}
