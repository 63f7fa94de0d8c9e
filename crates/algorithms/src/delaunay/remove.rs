//! Removal of a vertex: the hole that it leaves is filled with the triangles of the vertices around it.

use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use super::Triangulation;
use super::chain;
use super::locate::{Place, locate};
use super::mesh::{Edge, INFINITE, Mesh};

/// The invariant of holes: an edge has a vertex on its inner side.
pub(super) const APEX: &str = "an edge of a hole has a vertex on its inner side";
/// Why a vertex is not removed.
const MISSING: &str = "a vertex that is removed is in the triangulation";

impl Triangulation {
    /// Removes a vertex; where it stands for others, the smallest of them takes its place.
    ///
    /// # Errors
    /// The invariant that does not hold: the vertex is missing, or signs contradict each other.
    pub fn remove<P: Predicates + ?Sized>(&mut self, session: &P, v: Vertex) -> Result<(), &'static str> {
        let copies: Vec<[Vertex; 2]> = super::answer::resolved(&self.copies);
        if copies.iter().any(|&[copy, _]| copy == v) {
            self.copies = copies.into_iter().filter(|&[copy, _]| copy != v).collect();
            return Ok(());
        }
        let heir = copies.iter().find(|&&[_, of]| of == v).map(|&[copy, _]| copy);
        self.copies = copies
            .into_iter()
            .filter(|&[copy, _]| Some(copy) != heir)
            .map(|[copy, of]| [copy, if of == v { heir.unwrap_or(of) } else { of }])
            .collect();
        if self.mesh.is_empty() {
            let at = self.chain.iter().position(|&other| other == v).ok_or(MISSING)?;
            match heir {
                Some(heir) => self.chain[at] = heir,
                None => drop(self.chain.remove(at)),
            }
            return Ok(());
        }
        let Place::At(edge) = locate(session, &self.mesh, self.near, v)? else { return Err(MISSING) };
        match heir {
            Some(heir) => {
                self.mesh.rename(edge, heir);
                Ok(())
            }
            None => self.remove_star(session, edge),
        }
    }

    fn remove_star<P: Predicates + ?Sized>(&mut self, session: &P, edge: Edge) -> Result<(), &'static str> {
        let star: Vec<Edge> = self.mesh.around(edge).collect();
        let polygon: Vec<(Vertex, Edge)> =
            star.iter().map(|&edge| (self.mesh.start(edge), self.mesh.across(edge))).collect();
        if polygon.len() < 3 {
            return Err(APEX);
        }
        if let Some(rest) = self.rest_in_line(session, &polygon) {
            self.mesh.clear();
            self.chain = rest;
            return Ok(());
        }
        star.iter().for_each(|edge| self.mesh.free(edge.triangle()));
        let filled = self.fill_hole(session, polygon);
        self.look_for_round(session, &filled);
        self.near = filled.last().copied().unwrap_or(0);
        self.broken.map_or(Ok(()), Err)
    }

    /// The vertices that are left in their order, where they are all in one line.
    fn rest_in_line<P: Predicates + ?Sized>(&self, session: &P, polygon: &[(Vertex, Edge)]) -> Option<Vec<Vertex>> {
        // Then the vertex was on the hull, and all edges that it saw are on the hull as well.
        let infinite = polygon.iter().position(|&(v, _)| v == INFINITE)?;
        let mut rest: Vec<Vertex> = Vec::with_capacity(polygon.len());
        for at in 1..polygon.len() {
            let (v, outside) = polygon[(infinite + at) % polygon.len()];
            rest.push(v);
            if at + 1 < polygon.len() && !self.mesh.is_infinite(outside.triangle()) {
                return None;
            }
        }
        if let [first, second, others @ ..] = &rest[..]
            && others.iter().any(|&v| session.orient2d(Plane::Xy, *first, *second, v) != Sign::Zero)
        {
            return None;
        }
        if let [first, .., last] = rest[..]
            && chain::order(session, first, last) == Sign::Positive
        {
            rest.reverse();
        }
        Some(rest)
    }

    /// Fills a polygon, given by its vertices, each with the outer side of the edge that begins there; the new triangles.
    fn fill_hole<P: Predicates + ?Sized>(&mut self, session: &P, polygon: Vec<(Vertex, Edge)>) -> Vec<u32> {
        let mut open = vec![polygon];
        let mut filled = Vec::new();
        while let Some(mut polygon) = open.pop() {
            // The first edge has no infinite end.
            if let Some(at) = polygon.iter().position(|&(v, _)| v == INFINITE) {
                let length = polygon.len();
                polygon.rotate_left((at + 1) % length);
            }
            let at = match apex(session, &polygon) {
                Some(at) => at,
                None => {
                    self.broken = self.broken.or(Some(APEX));
                    2
                }
            };
            let [(a, base), (b, _)] = [polygon[0], polygon[1]];
            let edge = self.mesh.add(polygon[at].0, a, b);
            filled.push(edge.triangle());
            self.mesh.join(edge, base);
            close(&mut self.mesh, &mut open, &polygon[1..at], (polygon[at].0, edge.next()));
            close(&mut self.mesh, &mut open, &polygon[at..], (a, edge.previous()));
        }
        filled
    }
}

/// A part of a hole that a side of a triangle closes: one edge is linked to it, more are a hole of their own.
fn close(mesh: &mut Mesh, open: &mut Vec<Vec<(Vertex, Edge)>>, part: &[(Vertex, Edge)], side: (Vertex, Edge)) {
    match part {
        [(_, outside)] => mesh.join(side.1, *outside),
        _ => open.push([&[side], part].concat()),
    }
}

/// The place of the vertex that makes a triangle with the first edge: its circle has no other vertex of the polygon in it.
pub(super) fn apex<P: Predicates + ?Sized>(session: &P, polygon: &[(Vertex, Edge)]) -> Option<usize> {
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
