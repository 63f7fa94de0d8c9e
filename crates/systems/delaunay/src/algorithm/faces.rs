//! The canonical rule: a face of cocircular vertices is cut as a fan from its smallest index.
//!
//! The faces are those of the plane divided by all edges that must be there. If the four vertices of an edge and its
//! two triangles are on one circle, and no constraint is on the edge, another edge would also be Delaunay. Such edges
//! are called round. A face has a convex boundary, so the fan from any of its vertices consists of triangles. The fan
//! does not depend on the order of insertion.

use predicament_predicates::{Predicates, Sign};

use super::mesh::{Edge, Mesh};
use super::{Contradiction, Triangulation};

impl Triangulation {
    /// Cuts all faces by the rule. [`delaunay2d`](super::delaunay2d) does this itself; call it again after vertices
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

    /// Determines the round edges of these triangles.
    pub(super) fn look_for_round<P: Predicates + ?Sized>(&mut self, session: &P, triangles: &[u32]) {
        for &triangle in triangles {
            for edge in [0, 1, 2].map(|corner| Edge::new(triangle, corner)) {
                let outside = self.mesh.across(edge);
                // A hull edge is not round.
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
