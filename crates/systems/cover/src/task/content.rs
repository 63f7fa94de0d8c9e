//! A mesh with holes, and loops to cover.

use predicament_corpus::{Canon, Content, Items, List, Spelled, spelled_points};
use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::ConversionError;
use predicament_predicates::{Scene, Vertex};

/// A mesh, which may have no triangles, and the loops to cover.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct HoleScene {
    /// The triangles. The front of a triangle is the side from which its corners are seen counterclockwise.
    pub triangles: Vec<[Vertex; 3]>,
    /// The loops. The loop of a hole runs against the triangles around it.
    pub loops: Vec<Vec<Vertex>>,
    /// True if the loops are written in the suite, and not found in the mesh.
    pub are_written: bool,
}

impl HoleScene {
    /// A mesh with the loops of its holes, each from its smallest vertex, in the order of these vertices.
    ///
    /// # Errors
    /// [`ConversionError`] if the triangles are not a mesh with boundaries.
    pub fn of_holes(points: usize, triangles: Vec<[Vertex; 3]>) -> Result<HoleScene, ConversionError> {
        let mut mesh = HalfEdgeMesh::of_scene(points, &triangles)?;
        let starts: Vec<_> = mesh.boundary_loops(1).collect();
        let around = |start| {
            let mut around: Vec<Vertex> = mesh.vertex_loop(start).map(|v| mesh.scene_vertex(v)).collect();
            let first =
                (0..around.len()).min_by_key(|&at| [around[at], around[(at + 1) % around.len()]]).unwrap_or_default();
            around.rotate_left(first);
            around
        };
        let mut loops: Vec<Vec<Vertex>> = starts.into_iter().map(around).collect();
        loops.sort();
        Ok(HoleScene { triangles, loops, are_written: false })
    }
}

impl Content for HoleScene {
    fn count(&self) -> usize {
        self.loops.len()
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("cover");
        canon.vertices(self.triangles.as_flattened());
        canon.count(self.loops.len());
        self.loops.iter().for_each(|around| canon.vertices(around));
    }

    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let mut lists = vec![List::new("triangles", Items::tuples(&self.triangles))];
        if self.are_written {
            lists.push(List::required("loops", Items::Loops(self.loops.clone())));
        }
        Some(Spelled { lists, ..spelled_points(scene) })
    }
}
