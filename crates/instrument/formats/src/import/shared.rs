//! Vertices by their coordinates: equal ones are one vertex.

use std::collections::HashMap;

use predicament_predicates::Vertex;

/// Points, none of them twice. A symbolic perturbation moves vertices by identity: what is one place in a file
/// that repeats coordinates has to be one vertex.
#[derive(Debug)]
pub(super) struct SharedVertices<const N: usize> {
    points: Vec<[f64; N]>,
    // Only looked up, never iterated: its order reaches no output.
    vertices: HashMap<[u64; N], Vertex>,
}

impl<const N: usize> Default for SharedVertices<N> {
    fn default() -> SharedVertices<N> {
        SharedVertices { points: Vec::new(), vertices: HashMap::new() }
    }
}

impl<const N: usize> SharedVertices<N> {
    /// The one vertex with these coordinates: numbered as they come.
    pub(super) fn vertex(&mut self, point: [f64; N]) -> Vertex {
        // -0 and +0 are the same place.
        let key = point.map(|x| (x + 0.0).to_bits());
        let points = &mut self.points;
        *self.vertices.entry(key).or_insert_with(|| {
            points.push(point);
            Vertex::input(points.len() - 1)
        })
    }

    /// The coordinates of each vertex.
    pub(super) fn into_points(self) -> Vec<[f64; N]> {
        self.points
    }
}
