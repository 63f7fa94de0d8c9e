//! A mesh, and lines, rays or segments that may hit it.

use std::any::Any;
use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};

use crate::answer::{Extent, edges};
use predicament_corpus::{Canon, Content, Items, List, Parts, Spelled, numbered, unnumbered};
use predicament_predicates::{Dimension, Scene, Vertex};

/// A mesh with queries, each by two points.
///
/// Every point of a query is a separate vertex, even if its coordinates are those of a vertex of the mesh. The first
/// points of all queries are numbered before the vertices of the mesh, the second ones after them. So Simulation of
/// Simplicity moves one end of each query further than the mesh and the other end less far. For perturbations that
/// move a mesh as a whole, the points of queries are the second mesh.
#[derive(Debug)]
pub struct RayScene {
    /// The triangles. The front of a triangle is the side from which its corners are seen counterclockwise.
    pub triangles: Vec<[Vertex; 3]>,
    /// The queries.
    pub rays: Vec<[Vertex; 2]>,
    /// The part of each query's line that counts.
    pub extent: Extent,
    is_closed: bool,
    /// Data that an algorithm makes of the content once, for all backends; its type is the algorithm's.
    made: OnceLock<Box<dyn Any + Send + Sync>>,
}

impl RayScene {
    /// Combines triangles and queries.
    #[must_use]
    pub fn new(triangles: Vec<[Vertex; 3]>, rays: Vec<[Vertex; 2]>, extent: Extent) -> RayScene {
        RayScene { is_closed: is_closed(&triangles), triangles, rays, extent, made: OnceLock::new() }
    }

    /// True if every edge is used equally often in both directions: then winding numbers are defined.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// The data that `make` makes, once. The truth reads this type too, so the type does not name an algorithm.
    ///
    /// # Panics
    /// If it was made as another type.
    pub(super) fn made<T: Any + Send + Sync>(&self, make: impl FnOnce() -> T) -> &T {
        self.made.get_or_init(|| Box::new(make())).downcast_ref().expect("one type of data for each content")
    }
}

fn is_closed(triangles: &[[Vertex; 3]]) -> bool {
    let mut balance: BTreeMap<[Vertex; 2], i64> = BTreeMap::new();
    for [u, v] in triangles.iter().flat_map(|&corners| edges(corners)) {
        *balance.entry([u.min(v), u.max(v)]).or_default() += if u < v { 1 } else { -1 };
    }
    balance.values().all(|&sum| sum == 0)
}

/// The scene of a mesh and its queries, each as six coordinates: the first point, then the second.
///
/// # Panics
/// If a coordinate is not finite.
pub(super) fn parts(points: Vec<[f64; 3]>, triangles: &[[Vertex; 3]], rays: &[[f64; 6]], extent: Extent) -> Parts {
    let places: Vec<[f64; 3]> = rays.as_flattened().as_chunks().0.to_vec();
    let (all, numbers) = numbered(points, &places);
    let scene = Scene::new(Dimension::Three, all.into_flattened()).expect("finite points");
    let shifted = |v: Vertex| Vertex::input(v.index() + rays.len());
    let triangles = triangles.iter().map(|corners| corners.map(shifted)).collect();
    let scene = scene.with_second_mesh(numbers.iter().copied());
    Parts::new(scene, RayScene::new(triangles, numbers.as_chunks().0.to_vec(), extent))
}

impl Content for RayScene {
    fn count(&self) -> usize {
        self.rays.len()
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("mesh-rays");
        canon.text(self.extent.name());
        canon.vertices(self.triangles.as_flattened());
        canon.vertices(self.rays.as_flattened());
    }

    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let apart = unnumbered(scene, self.rays.as_flattened());
        let triangles: Vec<[Vertex; 3]> =
            self.triangles.iter().map(|corners| corners.map(|v| apart.vertex(v))).collect();
        let rays = apart.places.chunks(2).map(<[Vec<f64>]>::concat).collect();
        let lists =
            vec![List::required("triangles", Items::tuples(&triangles)), List::required("rays", Items::Rows(rays))];
        let words = vec![("extent", format!("\"{}\"", self.extent.name()))];
        Some(Spelled { points: apart.points, words, lists, ..Spelled::default() })
    }

    /// The tree of the moved scene is new.
    fn moved(&self, scene: Scene) -> (Scene, Option<Arc<dyn Content>>) {
        let moved = RayScene::new(self.triangles.clone(), self.rays.clone(), self.extent);
        (scene, Some(Arc::new(moved)))
    }
}
