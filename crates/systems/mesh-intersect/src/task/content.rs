//! Two meshes in one scene.

use std::sync::Arc;

use predicament_corpus::{Canon, Content, Parts, Spelled, spelled_points};
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Dimension, Scene};

use super::flaw::is_refused;
use predicament_mesh_locate::task::content::spelled_mesh;
use predicament_mesh_locate::task::probes::Surface;

/// Two meshes with disjoint vertices.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct TwoMeshes {
    /// The first mesh and the second; the second is the scene's second mesh for perturbations that move one mesh as a
    /// whole.
    pub meshes: [Arc<MaterialMesh>; 2],
    /// True if the meshes are taken as they are, valid or not (`check = false`).
    pub is_as_it_is: bool,
}

impl TwoMeshes {
    /// The number of triangles of both meshes.
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

    /// Writes `check = false` if it was given, or if the meshes would be refused without it.
    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let [first, second] = &self.meshes;
        let lists = vec![
            spelled_mesh(first, ["first", "first_regions"], |v| v),
            spelled_mesh(second, ["second", "second_regions"], |v| v),
        ];
        let words = if self.is_as_it_is || is_refused(scene, [first, second]) {
            vec![("check", "false".to_owned())]
        } else {
            Vec::new()
        };
        Some(Spelled { words, lists, ..spelled_points(scene) })
    }

    /// The moved scene has other lengths of primitives.
    fn moved(&self, scene: Scene) -> (Scene, Option<Arc<dyn Content>>) {
        let [first, second] = &self.meshes;
        (for_both(scene, [first, second]), None)
    }
}

/// A scene of two meshes with separate points.
pub(super) fn parts([first, second]: [Surface; 2]) -> Parts {
    let count = first.points.len();
    let coordinates = [first.points, second.points].concat();
    let scene = Scene::new(Dimension::Three, coordinates.into_flattened()).expect("finite points");
    with_meshes(scene, [first.mesh, second.mesh.shifted(count)], false)
}

/// A scene with these meshes over its points.
pub(super) fn with_meshes(scene: Scene, meshes: [MaterialMesh; 2], is_as_it_is: bool) -> Parts {
    let [first, second] = &meshes;
    Parts::new(for_both(scene, [first, second]), TwoMeshes { meshes: meshes.map(Arc::new), is_as_it_is })
}

/// A scene that stores the second mesh's vertices, for perturbations that move it, and the lengths of primitives, for
/// tolerances.
pub(super) fn for_both(scene: Scene, meshes: [&MaterialMesh; 2]) -> Scene {
    let lengths = meshes.map(|mesh| mesh.primitive_length(&scene));
    let second: Vec<_> = meshes[1].triangles().as_flattened().to_vec();
    scene.with_primitive_lengths(lengths).with_second_mesh(second)
}

#[cfg(test)]
mod tests {
    use predicament_predicates::Vertex;

    use super::*;

    #[test]
    fn lengths_follow_the_points() {
        let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(|face| face.map(Vertex::input));
        let mesh = MaterialMesh::of_closed(4, faces.to_vec()).unwrap();
        let corners = [[0., 0., 0.], [4., 0., 0.], [0., 2., 0.], [0., 0., 1.]];
        let both: Vec<[f64; 3]> = corners.into_iter().chain(corners.map(|point| point.map(|x| x / 4.0))).collect();
        let Parts { scene, content, .. } =
            with_meshes(Scene::from_points3(&both).unwrap(), [mesh.clone(), mesh.shifted(4)], false);
        assert_eq!(scene.primitive_lengths(), Some([4.0, 1.0]));
        let twice: Vec<[f64; 3]> = both.iter().map(|point| point.map(|x| 2.0 * x)).collect();
        let (moved, same) = content.moved(Scene::from_points3(&twice).unwrap());
        assert_eq!((moved.primitive_lengths(), same.is_none()), (Some([8.0, 2.0]), true));
        assert_eq!(moved.second_mesh(), scene.second_mesh());
    }
}
