//! Removal of a vertex: the hole is filled with triangles of the vertices around it.

use std::collections::HashMap;

use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use super::chain;
use super::hole::Side;
use super::locate::{Place, locate};
use super::mesh::{Edge, INFINITE};
use super::{Contradiction, Triangulation};

impl Triangulation {
    /// Removes a vertex; if it represents copies, the smallest of them takes its place.
    ///
    /// # Errors
    /// The invariant that does not hold: the vertex is missing, or signs contradict each other.
    pub fn remove<P: Predicates + ?Sized>(&mut self, session: &P, v: Vertex) -> Result<(), Contradiction> {
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
            let at = self.chain.iter().position(|&other| other == v).ok_or(Contradiction::Missing)?;
            match heir {
                Some(heir) => self.chain[at] = heir,
                None => drop(self.chain.remove(at)),
            }
            return Ok(());
        }
        let Place::At(edge) = locate(session, &self.mesh, self.near, v)? else { return Err(Contradiction::Missing) };
        match heir {
            Some(heir) => {
                self.mesh.rename(edge, heir);
                Ok(())
            }
            None => self.remove_star(session, edge),
        }
    }

    fn remove_star<P: Predicates + ?Sized>(&mut self, session: &P, edge: Edge) -> Result<(), Contradiction> {
        let star: Vec<Edge> = self.mesh.around(edge).collect();
        let polygon: Vec<(Vertex, Edge)> =
            star.iter().map(|&edge| (self.mesh.start(edge), self.mesh.across(edge))).collect();
        self.mesh.unmark();
        let mut corners: Vec<Vertex> = polygon.iter().map(|&(v, _)| v).collect();
        corners.sort_unstable();
        let is_disc = polygon.len() >= 3
            && corners.windows(2).all(|pair| pair[0] != pair[1])
            && star.iter().all(|edge| !self.mesh.mark(edge.triangle()))
            && polygon.iter().all(|(_, outside)| !self.mesh.is_marked(outside.triangle()));
        if !is_disc {
            return Err(Contradiction::Disc);
        }
        if let Some(rest) = self.rest_in_line(session, &polygon) {
            self.mesh.clear();
            self.chain = rest;
            return Ok(());
        }
        star.iter().for_each(|edge| self.mesh.free(edge.triangle()));
        let polygon = polygon.into_iter().map(|(v, outside)| (v, Side::Kept(outside))).collect();
        let filled = self.fill_hole(session, polygon, &mut HashMap::new());
        self.look_for_round(session, &filled);
        self.near = filled.last().copied().unwrap_or(0);
        self.broken.map_or(Ok(()), Err)
    }

    /// The remaining vertices in their order, if all are collinear.
    fn rest_in_line<P: Predicates + ?Sized>(&self, session: &P, polygon: &[(Vertex, Edge)]) -> Option<Vec<Vertex>> {
        // Then the vertex was on the hull, and all edges visible from it are on the hull as well.
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
}
