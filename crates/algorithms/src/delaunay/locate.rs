//! Point location: a walk from triangle to triangle.

use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use super::chain::order;
use super::mesh::{Edge, Mesh};

/// The invariant of the walk: in a Delaunay triangulation no triangle comes twice.
pub(super) const WALK: &str = "a walk toward a vertex ends";
/// The invariant of vertices on two sides of a triangle.
const CORNER: &str = "a vertex on two sides of a triangle is in the place of their corner";

/// Where a vertex is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Place {
    /// In the place of the vertex opposite of this edge.
    At(Edge),
    /// In this triangle or on its boundary, or beyond its edge where it is infinite.
    In(u32),
}

/// Walks to a vertex from a triangle on.
///
/// # Errors
/// The invariant that does not hold.
#[inline]
pub(super) fn locate<P: Predicates + ?Sized>(
    session: &P,
    mesh: &Mesh,
    near: u32,
    v: Vertex,
) -> Result<Place, &'static str> {
    let mut near = [near, mesh.across(Edge::new(near, 2)).triangle()].into_iter().chain(0..mesh.len());
    let triangle = near.find(|&triangle| !mesh.is_infinite(triangle)).ok_or(WALK)?;
    if let Some(edge) = mesh.opposite(triangle, v) {
        return Ok(Place::At(edge));
    }
    // All three sides of the first triangle are looked at, then the two by which a triangle was not entered.
    let first = [0, 1, 2].map(|corner| Edge::new(triangle, corner));
    let mut on: Option<Edge> = None;
    let mut next = None;
    for edge in first {
        match session.orient2d(Plane::Xy, mesh.start(edge), mesh.end(edge), v) {
            Sign::Positive => {}
            Sign::Negative => {
                next = Some(mesh.across(edge));
                break;
            }
            Sign::Zero => match on {
                None => on = Some(edge),
                Some(other) => return at_corner(session, mesh, [other, edge], v),
            },
        }
    }
    let Some(mut entered) = next else { return Ok(Place::In(triangle)) };
    for _ in 0..mesh.len() {
        let triangle = entered.triangle();
        if mesh.is_infinite(triangle) {
            return Ok(Place::In(triangle));
        }
        if mesh.apex(entered) == v {
            return Ok(Place::At(entered));
        }
        let edges = [entered.next(), entered.previous()];
        let [first, second] = edges.map(|edge| [mesh.start(edge), mesh.end(edge)]);
        let side = session.orient2d(Plane::Xy, first[0], first[1], v);
        if side == Sign::Negative {
            entered = mesh.across(edges[0]);
            continue;
        }
        match (side, session.orient2d(Plane::Xy, second[0], second[1], v)) {
            (_, Sign::Negative) => entered = mesh.across(edges[1]),
            (Sign::Zero, Sign::Zero) => return at_corner(session, mesh, edges, v),
            _ => return Ok(Place::In(triangle)),
        }
    }
    Err(WALK)
}

/// A vertex on two sides of a triangle.
#[cold]
#[inline(never)]
fn at_corner<P: Predicates + ?Sized>(
    session: &P,
    mesh: &Mesh,
    [e, f]: [Edge; 2],
    v: Vertex,
) -> Result<Place, &'static str> {
    let corner = if e.next() == f { f.next() } else { e.next() };
    if order(session, mesh.apex(corner), v) == Sign::Zero { Ok(Place::At(corner)) } else { Err(CORNER) }
}
