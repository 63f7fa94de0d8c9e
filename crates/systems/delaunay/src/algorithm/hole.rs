//! Holes: polygons that are filled with triangles whose circles contain none of the polygon's vertices.

use std::collections::HashMap;

use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use super::mesh::{Edge, INFINITE, Mesh};
use super::{Contradiction, Triangulation};

/// The other side of an edge of a hole.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Side {
    /// A triangle that is kept.
    Kept(Edge),
    /// The same hole, or another one that is filled with it; the name of the edge.
    Twin(Edge),
}

impl Triangulation {
    /// Fills a polygon, and returns the new triangles. The polygon is a list of vertices, each with the other side of
    /// the edge that begins there. The new side of each edge that has a twin is stored under the edge's name.
    ///
    /// The circle of a triangle contains no vertex of the polygon that is on the inner side of its first edge.
    pub(super) fn fill_hole<P: Predicates + ?Sized>(
        &mut self,
        session: &P,
        polygon: Vec<(Vertex, Side)>,
        twins: &mut HashMap<Edge, Edge>,
    ) -> Vec<u32> {
        let mut open = vec![polygon];
        let mut filled = Vec::new();
        while let Some(mut polygon) = open.pop() {
            // The first edge must not have the infinite vertex as an end.
            if let Some(at) = polygon.iter().position(|&(v, _)| v == INFINITE) {
                let length = polygon.len();
                polygon.rotate_left((at + 1) % length);
            }
            let at = match apex(session, &polygon) {
                Some(at) => at,
                None => {
                    self.broken = self.broken.or(Some(Contradiction::Apex));
                    2
                }
            };
            let [(a, base), (b, _)] = [polygon[0], polygon[1]];
            let edge = self.mesh.add(polygon[at].0, a, b);
            filled.push(edge.triangle());
            settle(&mut self.mesh, twins, edge, base);
            close(&mut self.mesh, twins, &mut open, &polygon[1..at], (polygon[at].0, edge.next()));
            close(&mut self.mesh, twins, &mut open, &polygon[at..], (a, edge.previous()));
        }
        filled
    }
}

/// Links a new edge to its other side.
fn settle(mesh: &mut Mesh, twins: &mut HashMap<Edge, Edge>, edge: Edge, side: Side) {
    match side {
        Side::Kept(outside) => mesh.join(edge, outside),
        Side::Twin(name) => drop(twins.insert(name, edge)),
    }
}

/// Closes a part of a hole with a side of a triangle: a part of one edge is linked, a larger part becomes a new hole.
fn close(
    mesh: &mut Mesh,
    twins: &mut HashMap<Edge, Edge>,
    open: &mut Vec<Vec<(Vertex, Side)>>,
    part: &[(Vertex, Side)],
    (v, edge): (Vertex, Edge),
) {
    match part {
        [(_, side)] => settle(mesh, twins, edge, *side),
        _ => open.push([&[(v, Side::Kept(edge))], part].concat()),
    }
}

/// The index of the vertex that makes a triangle with the first edge: its circle contains no other vertex of the
/// polygon.
fn apex<P: Predicates + ?Sized>(session: &P, polygon: &[(Vertex, Side)]) -> Option<usize> {
    let [(a, _), (b, _), others @ ..] = polygon else { return None };
    let mut best: Option<usize> = None;
    for (at, &(v, _)) in others.iter().enumerate() {
        let is_better = match best.map(|best| others[best].0) {
            _ if v == INFINITE => best.is_none(),
            None | Some(INFINITE) => session.orient2d(Plane::Xy, *a, *b, v) == Sign::Positive,
            Some(other) => {
                session.orient2d(Plane::Xy, *a, *b, v) == Sign::Positive
                    && session.incircle(*a, *b, other, v) == Sign::Positive
            }
        };
        if is_better {
            best = Some(at);
        }
    }
    best.map(|at| at + 2)
}
