//! Two objects in one scene.

use std::sync::{Arc, OnceLock};

use crate::algorithm::Indexed;
use crate::answer::Object;
use predicament_corpus::{Canon, Content, Items, List, Parts, Spelled, spelled_points};
use predicament_predicates::{Dimension, Scene, Vertex};

/// The parts of an object: loops of vertices in the plane, triangles in space.
pub type Loops = Vec<Vec<Vertex>>;

/// Two objects without common vertices: polygons in the plane, meshes in space.
///
/// For perturbations that move a mesh as a whole, the second object is the second mesh.
#[derive(Debug)]
pub struct TwoObjects {
    loops: [Loops; 2],
    objects: [Object; 2],
    indexed: OnceLock<[Indexed; 2]>,
}

impl TwoObjects {
    /// The objects of these loops (in the plane) or triangles (in space).
    #[must_use]
    pub fn new(dimension: Dimension, loops: [Loops; 2]) -> TwoObjects {
        let triangles = |parts: &Loops| {
            Object::new(&parts.iter().filter_map(|part| <[Vertex; 3]>::try_from(&part[..]).ok()).collect::<Vec<_>>())
        };
        let object = |parts: &Loops| match dimension {
            Dimension::Two => Object::polygon(parts),
            Dimension::Three => triangles(parts),
        };
        let objects = [object(&loops[0]), object(&loops[1])];
        TwoObjects { loops, objects, indexed: OnceLock::new() }
    }

    /// Both objects.
    #[must_use]
    pub fn objects(&self) -> [&Object; 2] {
        [&self.objects[0], &self.objects[1]]
    }

    /// Both objects with their trees. They are built once: they use no predicate, so all backends share them.
    pub fn indexed(&self, scene: &Scene) -> [&Indexed; 2] {
        let build = || self.objects.clone().map(|object| Indexed::new(scene, object));
        let [first, second] = self.indexed.get_or_init(build);
        [first, second]
    }
}

/// The scene of two objects.
pub(super) fn parts(scene: Scene, loops: [Loops; 2]) -> Parts {
    let content = TwoObjects::new(scene.dimension(), loops);
    let second = content.objects[1].vertices();
    Parts::new(scene.with_second_mesh(second), content)
}

impl Content for TwoObjects {
    fn count(&self) -> usize {
        1
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("distance");
        for loops in &self.loops {
            canon.text("object");
            for part in loops {
                canon.vertices(part);
            }
        }
    }

    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let mut spelled = spelled_points(scene);
        for (key, loops) in ["from", "to"].into_iter().zip(&self.loops) {
            let items = match scene.dimension() {
                Dimension::Two => Items::Loops(loops.clone()),
                Dimension::Three => Items::Tuples(loops.clone()),
            };
            spelled.lists.push(List::required(key, items));
        }
        Some(spelled)
    }

    /// The trees of the moved scene are new.
    fn moved(&self, scene: Scene) -> (Scene, Option<Arc<dyn Content>>) {
        let moved = TwoObjects::new(scene.dimension(), self.loops.clone());
        (scene, Some(Arc::new(moved)))
    }
}
