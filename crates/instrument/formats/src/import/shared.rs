//! Vertices shared by their coordinates: equal coordinates give one vertex.

use std::collections::HashMap;

use predicament_predicates::Vertex;

/// Distinct points. A symbolic perturbation moves vertices by identity, so coordinates that a file repeats must become
/// one vertex.
#[derive(Debug)]
pub(super) struct SharedVertices<const N: usize> {
    points: Vec<[f64; N]>,
    // The map is only looked up, never iterated: its order cannot reach the output.
    vertices: HashMap<[u64; N], Vertex>,
}

impl<const N: usize> Default for SharedVertices<N> {
    fn default() -> SharedVertices<N> {
        SharedVertices { points: Vec::new(), vertices: HashMap::new() }
    }
}

impl<const N: usize> SharedVertices<N> {
    /// The vertex with these coordinates; vertices are numbered in the order of their first occurrence.
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
