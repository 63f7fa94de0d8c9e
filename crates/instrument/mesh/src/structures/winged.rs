//! Winged edges: B. Baumgart, "Winged edge polyhedron representation", 1972.

use predicament_predicates::Vertex;

use super::Contradiction;
use crate::half_edge::{Link, Links};

/// An edge with its ends, its sides, and the edges before and after it around both sides.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct WingedEdge {
    /// The vertices at its start and its end.
    pub ends: [u32; 2],
    /// The faces on its left and its right; `None` on a boundary.
    pub faces: [Option<u32>; 2],
    /// The edges before and after it in the loop of the left face, then in that of the right face. The right face's
    /// loop goes from the end to the start.
    pub wings: [[u32; 2]; 2],
}

/// A mesh of winged edges.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct WingedEdges {
    /// The scene's vertex of each vertex.
    pub vertices: Vec<Vertex>,
    /// The edges.
    pub edges: Vec<WingedEdge>,
    /// The number of faces.
    pub faces: usize,
}

impl WingedEdges {
    /// The winged edges of a half-edge mesh: edge e goes along the half-edge 2e.
    ///
    /// # Panics
    /// If a half-edge links to one that is not there.
    #[must_use]
    pub fn new(links: &Links) -> WingedEdges {
        let previous = links.previous();
        let edges = (0..).zip(links.half_edges.chunks_exact(2)).map(|(e, sides): (u32, _)| WingedEdge {
            ends: [sides[1].end, sides[0].end],
            faces: [sides[0].face, sides[1].face],
            wings: [0, 1].map(|side| [previous[2 * e as usize + side] / 2, sides[side].next / 2]),
        });
        WingedEdges { vertices: links.vertices.clone(), edges: edges.collect(), faces: links.faces }
    }

    /// The links of the half-edge mesh: its half-edge 2e is the left side of edge e.
    ///
    /// # Errors
    /// The first edge whose wings do not have it as their own wing.
    pub fn to_links(&self) -> Result<Links, Contradiction> {
        let side_from = |edge: u32, vertex: u32| {
            let ends = self.edges.get(edge as usize)?.ends;
            (0..).zip(ends).find(|&(_, start)| start == vertex).map(|(side, _)| 2 * edge + side)
        };
        let mut half_edges = Vec::with_capacity(2 * self.edges.len());
        for (e, edge) in (0..).zip(&self.edges) {
            for side in [0, 1] {
                let end = edge.ends[1 - side];
                let next = side_from(edge.wings[side][1], end).ok_or(Contradiction::Edge(e))?;
                half_edges.push(Link { end, next, face: edge.faces[side] });
            }
        }
        let links = Links { vertices: self.vertices.clone(), half_edges, faces: self.faces };
        let mut times = vec![0_u8; links.half_edges.len()];
        for (h, link) in (0..).zip(&links.half_edges) {
            let next = link.next as usize;
            times[next] = times[next].saturating_add(1);
            if times[next] > 1 || self.edges[next / 2].wings[next % 2][0] != h / 2 {
                return Err(Contradiction::Edge(h / 2));
            }
        }
        Ok(links)
    }
}
