//! What of each mesh is near the other one: the triangles, and their edges.

use predicament_grid::{Bounds, shared};
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Scene, Vertex};
use rayon::prelude::*;

/// The triangles of a mesh that may meet the other one.
pub(super) struct Near {
    /// Their places in the mesh, ascending.
    pub triangles: Vec<u32>,
    /// Their edges, each once, from the smaller vertex to the larger, ascending.
    pub edges: Vec<[Vertex; 2]>,
    /// For each triangle here its edges: that from its first corner to its second, and so on.
    pub edges_of: Vec<[u32; 3]>,
    /// For each edge the end of its uses.
    ends: Vec<u32>,
    /// Uses of edges: three times the place of a triangle here, and the corner that it begins at.
    uses: Vec<u32>,
}

impl Near {
    /// What is near in both meshes, and their boxes. All that meets is in it.
    pub fn of(scene: &Scene, meshes: [&MaterialMesh; 2]) -> ([Near; 2], [Bounds<3>; 2]) {
        let box_of = meshes.map(|mesh| {
            let triangles = mesh.triangles();
            move |place: usize| Bounds::of(triangles[place].map(|v| scene.point3(v)))
        });
        let counts = meshes.map(|mesh| mesh.triangles().len());
        let ([first, second], bounds) = shared(counts, [&box_of[0], &box_of[1]]);
        ([Near::new(meshes[0], first), Near::new(meshes[1], second)], bounds)
    }

    fn new(mesh: &MaterialMesh, triangles: Vec<u32>) -> Near {
        let corners = |&place: &u32| mesh.triangles()[place as usize];
        let mut sides: Vec<([Vertex; 2], u32)> = Vec::with_capacity(3 * triangles.len());
        for (corners, here) in triangles.iter().map(corners).zip((0..).step_by(3)) {
            for corner in 0..3 {
                let [a, b] = [corners[corner as usize], corners[(corner as usize + 1) % 3]];
                sides.push(([a.min(b), a.max(b)], here + corner));
            }
        }
        sides.par_sort_unstable();
        let (mut edges, mut ends) = (Vec::with_capacity(sides.len() / 2), Vec::with_capacity(sides.len() / 2));
        let mut edges_of = vec![[0; 3]; triangles.len()];
        for of_edge in sides.chunk_by(|a, b| a.0 == b.0) {
            for &(_, side) in of_edge {
                edges_of[side as usize / 3][side as usize % 3] = number(edges.len());
            }
            edges.push(of_edge[0].0);
            ends.push(ends.last().unwrap_or(&0) + number(of_edge.len()));
        }
        Near { triangles, edges, edges_of, ends, uses: sides.into_iter().map(|(_, side)| side).collect() }
    }

    /// The triangles at an edge: place here, and the corner that the edge begins at there.
    pub fn uses(&self, edge: u32) -> impl Iterator<Item = (u32, usize)> + '_ {
        let start = edge.checked_sub(1).map_or(0, |before| self.ends[before as usize]);
        let uses = &self.uses[start as usize..self.ends[edge as usize] as usize];
        uses.iter().map(|&side| (side / 3, side as usize % 3))
    }

    /// The edge between two vertices, if it is near.
    pub fn edge(&self, a: Vertex, b: Vertex) -> Option<u32> {
        self.edges.binary_search(&[a.min(b), a.max(b)]).ok().map(number)
    }
}

/// A place in a list as it is stored.
pub(crate) fn number(place: usize) -> u32 {
    u32::try_from(place).expect("fewer than 2^32 sides of triangles")
}
