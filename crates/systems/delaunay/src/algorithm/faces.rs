//! The canonical rule: a face of vertices on one circle is cut as a fan from its smallest index.
//!
//! The faces are those of the plane divided by all edges that must be there: where an edge and its two triangles have their
//! four vertices on one circle, and no constraint is on it, another edge would do. Such edges are round. A face has a convex
//! boundary, so the fan from any of its vertices is made of triangles; it is the same whatever the order of insertion was.

use predicament_predicates::{Predicates, Sign};

use super::mesh::{Edge, Mesh};
use super::{Contradiction, Triangulation};

impl Triangulation {
    /// Cuts all faces by the rule. It is part of [`delaunay2d`](super::delaunay2d), and to be called again after vertices
    /// were inserted or removed one by one.
    pub fn cut_faces(&mut self) {
        self.mesh.unmark();
        for triangle in 0..self.mesh.len() {
            if self.mesh.is_infinite(triangle) || !self.mesh.has_round(triangle) || self.mesh.is_marked(triangle) {
                continue;
            }
            let is_inner = |mesh: &mut Mesh, inside: Edge, outside: Edge| {
                mesh.is_round(inside) && !mesh.is_constrained(inside) && !mesh.is_infinite(outside.triangle())
            };
            let filled = self.region.fill::<false>(&mut self.mesh, triangle, is_inner);
            if filled.is_ok() && self.region.is_simple(&self.mesh) {
                self.region.fan(&mut self.mesh);
            } else {
                self.broken = self.broken.or(Some(Contradiction::Face));
            }
        }
    }

    /// Finds out which edges of these triangles are round.
    pub(super) fn look_for_round<P: Predicates + ?Sized>(&mut self, session: &P, triangles: &[u32]) {
        for &triangle in triangles {
            for edge in [0, 1, 2].map(|corner| Edge::new(triangle, corner)) {
                let outside = self.mesh.across(edge);
                // What is beyond an edge of the hull is on no circle.
                let is_round = match (self.mesh.solid(triangle), self.mesh.solid(outside.triangle())) {
                    (Some([a, b, c]), Some(_)) => session.incircle(a, b, c, self.mesh.apex(outside)) == Sign::Zero,
                    _ => false,
                };
                self.mesh.set_round(edge, is_round);
                self.mesh.set_round(outside, is_round);
            }
        }
    }
}
