//! Vertices at one position.

use predicament_mesh::MaterialMesh;
use predicament_predicates::{Scene, Vertex};

use crate::algorithm::overlay::near::number;
use crate::algorithm::overlay::table::{Table, bits};

/// A vertex for all vertices at its position.
pub(super) struct Stands {
    /// For each input vertex of the scene, the first vertex at its position.
    of: Vec<u32>,
    /// For each input vertex that stands for others or itself, the meshes that have its position: a bit for each.
    meshes: Vec<u8>,
}

impl Stands {
    pub fn new(scene: &Scene, meshes: [&MaterialMesh; 2]) -> Stands {
        let mut used = vec![0_u8; scene.len()];
        for (mesh, bit) in meshes.into_iter().zip([1, 2]) {
            mesh.triangles().as_flattened().iter().for_each(|v| used[v.index()] |= bit);
        }
        let vertices: Vec<u32> = (0..number(scene.len())).filter(|&v| used[v as usize] != 0).collect();
        let words = |at: usize| bits(scene.point3(Vertex::input(vertices[at] as usize)));
        let table = Table::of(vertices.len(), &words);
        let first = |&at: &u32| {
            let own = words(at as usize);
            table.get(own, &|other| words(other) == own)
        };
        let places: Vec<u32> = (0..number(vertices.len())).collect();
        let mut of: Vec<u32> = (0..number(scene.len())).collect();
        for (&v, at) in vertices.iter().zip(predicament_grid::parallel::all(&places, &first)) {
            let first = vertices[at as usize];
            of[v as usize] = first;
            used[first as usize] |= used[v as usize];
        }
        Stands { of, meshes: used }
    }

    /// The first vertex at the position of an input vertex.
    pub fn of(&self, v: Vertex) -> Vertex {
        Vertex::input(self.of[v.index()] as usize)
    }

    /// True if both meshes have a vertex at this position.
    pub fn is_of_both(&self, v: Vertex) -> bool {
        self.meshes[self.of[v.index()] as usize] == 3
    }
}
