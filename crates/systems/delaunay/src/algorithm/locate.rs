//! Point location: a walk from triangle to triangle.
//!
//! A visibility walk is short if triangles are of similar size. It leaves a triangle by any side that separates it from
//! the vertex. If thousands of triangles share a far vertex, the walk can go all the way round that vertex. So a walk
//! that gets long is restarted as a straight walk: only through triangles that the segment to the vertex meets.

use super::Contradiction;
use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use super::chain::order;
use super::mesh::{Edge, Mesh};

/// The number of steps after which a walk is restarted as a straight walk.
const LONG: u32 = 32;

/// The place of a vertex in the triangulation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Place {
    /// At the vertex opposite of this edge.
    At(Edge),
    /// In this triangle or on its boundary; beyond the triangle's edge if it is infinite.
    In(u32),
}

/// Walks to a vertex, starting from a triangle.
///
/// # Errors
/// If an invariant does not hold; the error names it.
#[inline]
pub(super) fn locate<P: Predicates + ?Sized>(
    session: &P,
    mesh: &Mesh,
    near: u32,
    v: Vertex,
) -> Result<Place, Contradiction> {
    let mut near = [near, mesh.across(Edge::new(near, 2)).triangle()].into_iter().chain(0..mesh.len());
    let triangle = near.find(|&triangle| !mesh.is_infinite(triangle)).ok_or(Contradiction::Walk)?;
    if let Some(edge) = mesh.opposite(triangle, v) {
        return Ok(Place::At(edge));
    }
    // In the first triangle all three sides are tested, then the two sides by which a triangle was not entered.
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
    for step in 0..mesh.len() {
        if step == LONG {
            entered = straight(session, mesh, first[0], v).unwrap_or(entered);
        }
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
    Err(Contradiction::Walk)
}

/// Walks straight from the vertex opposite of an edge to a vertex. Returns the edge by which the walk enters the last
/// triangle: one that contains the vertex, or an infinite one. `None` if signs contradict each other, or no triangle at
/// the start is towards the vertex.
#[cold]
#[inline(never)]
fn straight<P: Predicates + ?Sized>(session: &P, mesh: &Mesh, edge: Edge, v: Vertex) -> Option<Edge> {
    let start = mesh.apex(edge);
    let side = |a: Vertex, b: Vertex, c: Vertex| session.orient2d(Plane::Xy, a, b, c);
    // Around the start, counterclockwise, to the triangle that the segment enters.
    let around = std::iter::successors(Some(edge), |&edge| Some(mesh.across(edge.next()).next()));
    let mut towards = around.take(mesh.len() as usize).filter(|edge| !mesh.is_infinite(edge.triangle()));
    let edge = towards.find(|&edge| {
        side(start, mesh.start(edge), v) != Sign::Negative && side(start, mesh.end(edge), v) == Sign::Negative
    })?;
    let is_beyond = |edge: Edge| side(mesh.start(edge), mesh.end(edge), v) == Sign::Negative;
    if !is_beyond(edge) {
        return Some(edge.next());
    }
    let mut entered = mesh.across(edge);
    for _ in 0..mesh.len() {
        let apex = mesh.apex(entered);
        if mesh.is_infinite(entered.triangle()) || apex == v {
            return Some(entered);
        }
        let next = if side(start, v, apex) == Sign::Negative { entered.previous() } else { entered.next() };
        if !is_beyond(next) {
            return Some(entered);
        }
        entered = mesh.across(next);
    }
    None
}

/// Handles a vertex on two sides of a triangle.
#[cold]
#[inline(never)]
fn at_corner<P: Predicates + ?Sized>(
    session: &P,
    mesh: &Mesh,
    [e, f]: [Edge; 2],
    v: Vertex,
) -> Result<Place, Contradiction> {
    let corner = if e.next() == f { f.next() } else { e.next() };
    if order(session, mesh.apex(corner), v) == Sign::Zero { Ok(Place::At(corner)) } else { Err(Contradiction::Corner) }
}
