//! Quad edges: L. Guibas and J. Stolfi, "Primitives for the manipulation of general subdivisions and the computation of
//! Voronoi diagrams", 1985.

use predicament_predicates::Vertex;

use super::Contradiction;
use crate::half_edge::{Link, Links};

/// A mesh and its dual. Each edge has four directed edges: e, Rot(e) from its right to its left face, Sym(e) and
/// Rot⁻¹(e). The directed edges of edge i are 4i to 4i + 3, in this order.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct QuadEdges {
    /// The scene's vertex of each vertex.
    pub vertices: Vec<Vertex>,
    /// The next directed edge counterclockwise around the origin of each.
    pub onext: Vec<u32>,
    /// The origin of each directed edge: a vertex, or a face where the number is odd; `None` for the outside of a
    /// boundary.
    pub origin: Vec<Option<u32>>,
    /// The number of faces.
    pub faces: usize,
}

/// The directed edge after some quarter turns counterclockwise.
const fn turned(edge: u32, quarters: u32) -> u32 {
    (edge & !3) | ((edge + quarters) & 3)
}

impl QuadEdges {
    /// The quad edges of a half-edge mesh: the half-edges 2i and 2i + 1 are the directed edges 4i and 4i + 2.
    ///
    /// # Panics
    /// If a half-edge links to one that is not there.
    #[must_use]
    pub fn new(links: &Links) -> QuadEdges {
        let previous = links.previous();
        let count = 2 * links.half_edges.len();
        let (mut onext, mut origin) = (vec![0; count], vec![None; count]);
        for (h, link) in (0..).zip(&links.half_edges) {
            let edge = 2 * h;
            // The edge before h ends at the origin and has the same face on its left.
            onext[edge as usize] = 2 * (previous[h as usize] ^ 1);
            origin[edge as usize] = Some(links.start(h));
            // Rot⁻¹(e) starts at the left face, whose boundary is the loop of h.
            let dual = turned(edge, 3) as usize;
            onext[dual] = turned(2 * link.next, 3);
            origin[dual] = link.face;
        }
        QuadEdges { vertices: links.vertices.clone(), onext, origin, faces: links.faces }
    }

    /// Rot(e): the dual edge from the right to the left face.
    #[must_use]
    pub const fn rot(edge: u32) -> u32 {
        turned(edge, 1)
    }

    /// Sym(e): the edge in the other direction.
    #[must_use]
    pub const fn sym(edge: u32) -> u32 {
        turned(edge, 2)
    }

    /// Rot⁻¹(e): the dual edge from the left to the right face.
    #[must_use]
    pub const fn inv_rot(edge: u32) -> u32 {
        turned(edge, 3)
    }

    /// Lnext(e): the next edge counterclockwise around the left face.
    ///
    /// # Panics
    /// If there is no such edge.
    #[must_use]
    pub fn lnext(&self, edge: u32) -> u32 {
        QuadEdges::rot(self.onext[QuadEdges::inv_rot(edge) as usize])
    }

    /// The links of the half-edge mesh, without the dual.
    ///
    /// # Errors
    /// The first directed edge that breaks the rule of the paper about duals (section 2.3), or whose ring leaves its
    /// origin.
    pub fn to_links(&self) -> Result<Links, Contradiction> {
        let onext = |edge: u32| self.onext.get(edge as usize).copied();
        let ring = |edge: u32| onext(QuadEdges::rot(onext(QuadEdges::rot(edge))?));
        let count = u32::try_from(self.onext.len()).unwrap_or(u32::MAX);
        let stays = |edge: u32| {
            onext(edge).is_some_and(|next| {
                next & 1 == edge & 1 && self.origin.get(next as usize) == self.origin.get(edge as usize)
            })
        };
        if let Some(wrong) = (0..count).find(|&edge| ring(edge) != Some(edge) || !stays(edge)) {
            return Err(Contradiction::Ring(wrong));
        }
        let mut half_edges = Vec::with_capacity(self.onext.len() / 2);
        for edge in (0..count).step_by(2) {
            let end = self.origin[QuadEdges::sym(edge) as usize].ok_or(Contradiction::Edge(edge / 4))?;
            let face = self.origin[QuadEdges::inv_rot(edge) as usize];
            half_edges.push(Link { end, next: self.lnext(edge) / 2, face });
        }
        Ok(Links { vertices: self.vertices.clone(), half_edges, faces: self.faces })
    }
}
