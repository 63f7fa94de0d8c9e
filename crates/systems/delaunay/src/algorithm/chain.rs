//! Collinear vertices, as long as all vertices are collinear.

use predicament_predicates::{Axis, Plane, Predicates, Sign, Vertex};

use super::mesh::{Edge, INFINITE, Mesh};
use predicament_grid::sort::sort_by_sign;

/// The order of two vertices by x, then by y.
pub(super) fn order<P: Predicates + ?Sized>(session: &P, a: Vertex, b: Vertex) -> Sign {
    match session.compare(Axis::X, a, b) {
        Sign::Zero => session.compare(Axis::Y, a, b),
        sign => sign,
    }
}

/// True if a vertex collinear with two others is strictly between them.
pub(super) fn is_between<P: Predicates + ?Sized>(session: &P, a: Vertex, b: Vertex, v: Vertex) -> bool {
    let side = order(session, a, v);
    side != Sign::Zero && side == order(session, v, b)
}

/// Vertices in their order, one for each place, and each other vertex with the first one in its place.
pub(super) fn sorted<P: Predicates + ?Sized>(session: &P, vertices: &[Vertex]) -> (Vec<Vertex>, Vec<[Vertex; 2]>) {
    let scene = session.scene();
    let key = |v: Vertex| scene.point2(Plane::Xy, v);
    let mut sorted = vertices.to_vec();
    // Coordinates are finite, and zeros of either sign are equal.
    sorted.sort_unstable_by(|&v, &w| key(v).partial_cmp(&key(w)).unwrap_or(std::cmp::Ordering::Equal).then(v.cmp(&w)));
    sort_by_sign(&mut sorted, |a, b| order(session, a, b));
    let mut copies = Vec::new();
    let mut chain: Vec<Vertex> = Vec::with_capacity(sorted.len());
    for v in sorted {
        match chain.last() {
            Some(&last) if order(session, last, v) == Sign::Zero => copies.push([v, last]),
            _ => chain.push(v),
        }
    }
    (chain, copies)
}

/// Joins a chain to a vertex off its line: adds the triangles between them and the infinite triangles around.
pub(super) fn fan(mesh: &mut Mesh, chain: &[Vertex], v: Vertex, side: Sign) {
    let chain: Vec<Vertex> = match side {
        Sign::Negative => chain.iter().rev().copied().collect(),
        _ => chain.to_vec(),
    };
    let (Some(&first), Some(&last)) = (chain.first(), chain.last()) else { return };
    // The sides of triangles between the chain and v, from the first one to the last.
    let mut open: Option<Edge> = None;
    let mut inner = Vec::with_capacity(chain.len() + 1);
    for pair in chain.windows(2) {
        let edge = mesh.add(v, pair[0], pair[1]);
        match open {
            None => inner.push(edge.previous()),
            Some(open) => mesh.link(open, edge.previous()),
        }
        inner.push(edge);
        open = Some(edge.next());
    }
    inner.extend(open);
    // From v to the first vertex of the chain, along the chain, and back to v: the hull, counterclockwise.
    let ends = [v].into_iter().chain(chain.iter().copied()).chain([v]).collect::<Vec<_>>();
    assert_eq!((ends[1], ends[ends.len() - 2]), (first, last));
    let outer: Vec<Edge> = ends.windows(2).map(|pair| mesh.add(INFINITE, pair[1], pair[0])).collect();
    for (at, (&outside, &inside)) in outer.iter().zip(&inner).enumerate() {
        mesh.link(outside, inside);
        // The infinite triangle of the next hull edge begins at the end of this one.
        mesh.link(outside.previous(), outer[(at + 1) % outer.len()].next());
    }
}
