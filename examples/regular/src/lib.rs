//! The weighted Delaunay triangulation of points in the plane: a regular triangulation.
//!
//! A triangle belongs to it if no vertex conflicts with the triangle's power circle. A vertex of small weight can be in
//! none. The algorithm knows two predicates: the turn, and the power test, which the project ships as a
//! formula. It is as short as possible (gift wrapping, one pass over all vertices per triangle), and needs signs that
//! are never zero: a session of `sos`.

use std::collections::BTreeSet;

use predicament_predicates::{Axis, Declined, Derived, Plane, PredicateKind, Predicates, Sign, Vertex};

/// The reason why there is no triangulation.
#[derive(Debug)]
pub enum Undone {
    /// The session does not answer one of the two predicates.
    Declined(Declined),
    /// Answers contradict each other: more triangles than a triangulation has.
    Contradiction,
}

/// The counterclockwise triangles of the weighted Delaunay triangulation of a scene's vertices, in ascending order.
///
/// Each triangle begins with its smallest vertex. Three vertices or more that are not in line have a triangle.
///
/// # Errors
/// [`Undone`] with the reason.
pub fn triangles<P: Predicates + ?Sized>(session: &P) -> Result<Vec<[Vertex; 3]>, Undone> {
    let power = Derived::named("side_of_power_circle").expect("the project ships the power test");
    session.supports(PredicateKind::Derived(power)).map_err(Undone::Declined)?;
    session.supports(PredicateKind::Orient2d).map_err(Undone::Declined)?;
    let vertices: Vec<Vertex> = session.scene().vertices().collect();
    let is_left =
        |[a, b]: [Vertex; 2], c: Vertex| c != a && c != b && session.orient2d(Plane::Xy, a, b, c) == Sign::Positive;
    // The vertex left of an edge whose power circle with the edge no other vertex conflicts with.
    let apex = |edge: [Vertex; 2]| {
        let left = vertices.iter().copied().filter(|&c| is_left(edge, c));
        left.reduce(|c, d| match session.sign(power, &[edge[0], edge[1], c, d]) {
            Sign::Positive => d,
            _ => c,
        })
    };
    // The leftmost vertex is a corner of the hull, and weights do not matter there.
    let order = |a: &Vertex, b: &Vertex| session.compare(Axis::X, *a, *b).cmp(&Sign::Zero);
    let Some(first) = vertices.iter().copied().min_by(order) else { return Ok(Vec::new()) };
    let others = vertices.iter().copied().filter(|&v| v != first);
    let Some(next) = others.reduce(|b, c| if is_left([first, b], c) { b } else { c }) else { return Ok(Vec::new()) };
    let (mut found, mut done, mut open) = (BTreeSet::new(), BTreeSet::new(), vec![[first, next]]);
    while let Some([a, b]) = open.pop() {
        if !done.insert([a, b]) {
            continue;
        }
        let Some(c) = apex([a, b]) else { continue };
        let [x, y, z] = [a, b, c];
        found.insert(if x < y && x < z {
            [x, y, z]
        } else if y < z {
            [y, z, x]
        } else {
            [z, x, y]
        });
        if found.len() > 2 * vertices.len() {
            return Err(Undone::Contradiction);
        }
        done.extend([[b, c], [c, a]]);
        open.extend([[b, a], [c, b], [a, c]]);
    }
    Ok(found.into_iter().collect())
}
