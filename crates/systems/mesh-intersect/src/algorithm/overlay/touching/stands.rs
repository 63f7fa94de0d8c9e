//! Vertices at one position.

use predicament_mesh::MaterialMesh;
use predicament_predicates::{Scene, Vertex};

use crate::algorithm::overlay::near::number;
use crate::algorithm::overlay::table::{Table, bits};

/// A vertex for all vertices at its position.
pub(super) struct Stands {
    /// For each input vertex of the scene, the first vertex at its position.
    of: Vec<u32>,
}

impl Stands {
    pub fn new(scene: &Scene, meshes: [&MaterialMesh; 2]) -> Stands {
        let mut used = vec![false; scene.len()];
        meshes.iter().flat_map(|mesh| mesh.triangles().as_flattened()).for_each(|v| used[v.index()] = true);
        let vertices: Vec<u32> = (0..number(scene.len())).filter(|&v| used[v as usize]).collect();
        let words = |at: usize| bits(scene.point3(Vertex::input(vertices[at] as usize)));
        let table = Table::of(vertices.len(), &words);
        let first = |&at: &u32| {
            let own = words(at as usize);
            table.get(own, &|other| words(other) == own)
        };
        let places: Vec<u32> = (0..number(vertices.len())).collect();
        let mut of: Vec<u32> = (0..number(scene.len())).collect();
        for (&v, at) in vertices.iter().zip(predicament_grid::parallel::all(&places, &first)) {
            of[v as usize] = vertices[at as usize];
        }
        Stands { of }
    }

    /// The first vertex at the position of an input vertex.
    pub fn of(&self, v: Vertex) -> Vertex {
        Vertex::input(self.of[v.index()] as usize)
    }
}
