//! Vertices at one position, and the triangles that both meshes have.

use predicament_mesh::MaterialMesh;
use predicament_predicates::{Scene, Vertex};
use rayon::prelude::*;

use crate::algorithm::overlay::near::number;

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
        // -0 and 0 are one position.
        let key = |v: u32| scene.point3(Vertex::input(v as usize)).map(|x| (x + 0.0).to_bits());
        let vertices = (0..number(scene.len())).into_par_iter().filter(|&v| used[v as usize] != 0);
        let mut order: Vec<([u64; 3], u32)> = vertices.map(|v| (key(v), v)).collect();
        order.par_sort_unstable();
        let mut of: Vec<u32> = (0..number(scene.len())).collect();
        for same in order.chunk_by(|a, b| a.0 == b.0) {
            let first = same[0].1;
            for &(_, v) in &same[1..] {
                of[v as usize] = first;
                used[first as usize] |= used[v as usize];
            }
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

    /// For each triangle of either mesh, the other mesh's triangle with the same corners.
    pub fn twins(&self, meshes: [&MaterialMesh; 2]) -> [Vec<Option<u32>>; 2] {
        let sorted = meshes.map(|mesh| {
            let triangles = mesh.triangles().par_iter().enumerate();
            let shared = triangles.filter(|(_, corners)| corners.iter().all(|&v| self.is_of_both(v)));
            let mut all: Vec<([Vertex; 3], u32)> = shared
                .map(|(at, corners)| {
                    let mut corners = corners.map(|v| self.of(v));
                    corners.sort_unstable();
                    (corners, number(at))
                })
                .collect();
            all.par_sort_unstable();
            all
        });
        let mut twins = meshes.map(|mesh| vec![None; mesh.triangles().len()]);
        let [first, second] = &sorted;
        let mut at = 0;
        for &(corners, triangle) in first {
            while second.get(at).is_some_and(|other| other.0 < corners) {
                at += 1;
            }
            if let Some(&(_, other)) = second.get(at).filter(|other| other.0 == corners) {
                twins[0][triangle as usize] = Some(other);
                twins[1][other as usize] = Some(triangle);
            }
        }
        twins
    }
}
