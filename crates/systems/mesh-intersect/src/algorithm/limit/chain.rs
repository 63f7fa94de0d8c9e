//! Chains of directed edges: the sums of the borders of triangles.

use predicament_predicates::Vertex;

/// Edges with the number of times that they are passed from the smaller vertex to the larger, less the times back.
#[derive(Default)]
pub(crate) struct Chain {
    edges: Vec<([Vertex; 2], i32)>,
}

impl Chain {
    /// Adds the border of a triangle `times` times.
    pub fn add(&mut self, [a, b, c]: [Vertex; 3], times: i32) {
        for [a, b] in [[a, b], [b, c], [c, a]] {
            if a != b {
                self.edges.push(if a < b { ([a, b], times) } else { ([b, a], -times) });
            }
        }
    }

    /// The edges that are passed more often in one direction than in the other, ascending.
    pub fn open(mut self) -> Vec<[Vertex; 2]> {
        self.edges.sort_unstable();
        let groups = self.edges.chunk_by(|a, b| a.0 == b.0);
        groups.filter(|group| group.iter().map(|(_, times)| times).sum::<i32>() != 0).map(|group| group[0].0).collect()
    }
}
