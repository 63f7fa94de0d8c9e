//! The distance between vertices of the input and the vertices that they have become, bounded in doubles.
//!
//! A vertex u moves into v, and with it all vertices that moved into u before. Their distance to v is at most their
//! distance to u plus the distance of u and v. Every operation is rounded up.

use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::MeshVertex;
use predicament_predicates::{Scene, Vertex};

pub(super) struct Reach<'s> {
    scene: &'s Scene,
    /// For each vertex of the mesh a bound on the distance to the vertices that moved into it.
    bounds: Vec<f64>,
    largest: f64,
}

impl<'s> Reach<'s> {
    pub(super) fn new(scene: &'s Scene, mesh: &HalfEdgeMesh) -> Reach<'s> {
        let count = mesh.vertices().last().map_or(0, |v| v.index() + 1);
        Reach { scene, bounds: vec![0.0; count], largest: 0.0 }
    }

    /// Moves a vertex into another one.
    pub(super) fn join(&mut self, gone: MeshVertex, kept: MeshVertex, scene: [Vertex; 2]) {
        let way = distance(scene.map(|v| self.scene.point3(v)));
        let through = (self.bounds[gone.index()] + way).next_up();
        let bound = &mut self.bounds[kept.index()];
        *bound = bound.max(through);
        self.largest = self.largest.max(*bound);
    }

    /// The largest bound of all vertices.
    pub(super) fn largest(&self) -> f64 {
        self.largest
    }
}

/// A bound on the distance of two points, a few roundings above it; infinite if it overflows.
fn distance([a, b]: [[f64; 3]; 2]) -> f64 {
    let sides = [0, 1, 2].map(|axis| (a[axis] - b[axis]).abs().next_up());
    let longest = sides.into_iter().fold(0.0, f64::max);
    if longest.is_infinite() {
        return longest;
    }
    // A square that underflows is rounded up to a positive number.
    let shares = sides.map(|side| (side / longest).next_up());
    let squares = shares.map(|share| (share * share).next_up());
    let sum = (squares[0] + squares[1]).next_up() + squares[2];
    (longest * sum.next_up().sqrt().next_up()).next_up()
}
