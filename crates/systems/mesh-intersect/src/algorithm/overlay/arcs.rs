//! The faces into which segments divide a triangle, from adjacency alone: no predicate is used here.
//!
//! Nodes around the triangle come first, counterclockwise: corners, and the points where its edges pass through other
//! triangles. One segment begins at each such point. The inner nodes are points where edges of the other mesh pass
//! through the triangle. Each has a segment for each triangle at such an edge, in counterclockwise order.

use super::Contradiction;
use predicament_predicates::Vertex;

/// A part of two triangles' common line, between two nodes; with the region of the other mesh on its left, as seen from
/// the front, and on its right.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment {
    pub nodes: [u32; 2],
    pub left: u32,
    pub right: u32,
}

/// A triangle with segments in it.
#[derive(Clone, Default, Debug)]
pub(super) struct Divided {
    /// The vertex of each node.
    pub vertices: Vec<Vertex>,
    /// The number of nodes around the triangle.
    pub around: usize,
    pub segments: Vec<Segment>,
    /// For each inner node, the ends of segments there, counterclockwise: twice the index of the segment, plus one if
    /// the segment ends here.
    pub inside: Vec<Vec<u32>>,
    /// For each node around the triangle, the region along the border after it.
    pub regions: Vec<u32>,
    /// For each node around the triangle, the triangle's edges through it, as bits.
    pub lines: Vec<u64>,
    /// The other triangle of each end of a segment, ascending, and its node.
    pub ends: Vec<(u32, u32)>,
}

/// A walk around a face, with the face on its left.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Walk {
    pub vertices: Vec<Vertex>,
    /// The region of the other mesh that contains the face.
    pub region: u32,
    /// True if it passes along the border of the triangle.
    pub is_at_border: bool,
}

impl Divided {
    /// The walks around all faces: one for each face, and one more for each hole.
    ///
    /// # Errors
    /// The invariant that fails.
    pub fn walks(&self) -> Result<Vec<Walk>, Contradiction> {
        let around = self.around;
        // Arcs: those around the triangle, each from the node of its index, then both directions of each segment.
        let arcs = around + 2 * self.segments.len();
        let mut leaves: Vec<Option<usize>> = vec![None; around];
        for (segment, place) in self.segments.iter().zip((around..).step_by(2)) {
            for (node, arc) in [(segment.nodes[0], place), (segment.nodes[1], place + 1)] {
                if let Some(leaves) = leaves.get_mut(node as usize)
                    && leaves.replace(arc).is_some()
                {
                    return Err(Contradiction::Chain);
                }
            }
        }
        let segment = |arc: usize| self.segments[(arc - around) / 2];
        let ends = |arc: usize| {
            if arc < around {
                return [arc, (arc + 1) % around];
            }
            let [from, to] = segment(arc).nodes.map(|node| node as usize);
            if (arc - around).is_multiple_of(2) { [from, to] } else { [to, from] }
        };
        let next = |arc: usize| {
            let [_, node] = ends(arc);
            if node < around {
                return Some(if arc < around { leaves[node].unwrap_or(node) } else { node });
            }
            // The reverse direction, then clockwise from there.
            let back = (arc - around) ^ 1;
            let there = &self.inside[node - around];
            let at = there.iter().position(|&end| end as usize == back)?;
            Some(around + there[(at + there.len() - 1) % there.len()] as usize)
        };
        let mut is_done = vec![false; arcs];
        let mut walks = Vec::new();
        for first in 0..arcs {
            if is_done[first] {
                continue;
            }
            let (mut vertices, mut region, mut is_at_border) = (Vec::new(), None, false);
            let mut arc = first;
            while !std::mem::replace(&mut is_done[arc], true) {
                let [node, _] = ends(arc);
                vertices.push(self.vertices[node]);
                let here = if arc < around {
                    is_at_border = true;
                    self.regions[node]
                } else if (arc - around).is_multiple_of(2) {
                    segment(arc).left
                } else {
                    segment(arc).right
                };
                if *region.get_or_insert(here) != here {
                    return Err(Contradiction::Region);
                }
                arc = next(arc).ok_or(Contradiction::Chain)?;
            }
            if arc != first || vertices.len() < 3 {
                return Err(Contradiction::Chain);
            }
            walks.push(Walk { vertices, region: region.ok_or(Contradiction::Region)?, is_at_border });
        }
        Ok(walks)
    }
}
