//! Two meshes in one scene.

use std::sync::Arc;

use predicament_corpus::{Canon, Content, Parts};
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Dimension, Scene};

use crate::mesh_locate::probes::Surface;

/// Two meshes over vertices of their own.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TwoMeshes {
    /// The first mesh and the second, which is the scene's second mesh for perturbations that move one as a whole.
    pub meshes: [Arc<MaterialMesh>; 2],
}

impl TwoMeshes {
    /// How many triangles both have.
    #[must_use]
    pub fn triangles(&self) -> usize {
        self.meshes.iter().map(|mesh| mesh.triangles().len()).sum()
    }
}

impl Content for TwoMeshes {
    fn count(&self) -> usize {
        self.triangles()
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("mesh-intersect");
        for mesh in &self.meshes {
            canon.count(mesh.triangles().len());
            for (triangle, sides) in mesh.triangles().iter().zip(mesh.sides()) {
                canon.vertices(triangle);
                sides.iter().for_each(|&region| canon.count(region as usize));
            }
        }
    }
}

/// A scene of two meshes, each over points of its own.
pub(super) fn parts([first, second]: [Surface; 2]) -> Parts {
    let count = first.points.len();
    let coordinates = [first.points, second.points].concat();
    let scene = Scene::new(Dimension::Three, coordinates.into_flattened()).expect("finite points");
    with_meshes(scene, [first.mesh, second.mesh.shifted(count)])
}

/// A scene with these meshes over its points.
pub(super) fn with_meshes(scene: Scene, meshes: [MaterialMesh; 2]) -> Parts {
    Parts::new(for_both(scene, &meshes), TwoMeshes { meshes: meshes.map(Arc::new) })
}

/// A scene that says which vertices are the second mesh's, for perturbations that move it, and how long primitives are, for tolerances.
pub(super) fn for_both(scene: Scene, meshes: &[MaterialMesh; 2]) -> Scene {
    let lengths = meshes.each_ref().map(|mesh| mesh.primitive_length(&scene));
    let second: Vec<_> = meshes[1].triangles().as_flattened().to_vec();
    scene.with_primitive_lengths(lengths).with_second_mesh(second)
}
