//! Maps given by indices.

use predicament_mesh::PolygonMap;
use predicament_predicates::{Scene, Vertex};

fn ids(indices: impl IntoIterator<Item = usize>) -> Vec<Vertex> {
    indices.into_iter().map(Vertex::input).collect()
}

/// A map of rings over the first vertices; every vertex of the scene is a query.
pub fn problem(points: &[[f64; 2]], regions: &[Vec<Vec<usize>>]) -> (PolygonMap, Scene) {
    let mut map = PolygonMap::new();
    for (at, rings) in regions.iter().enumerate() {
        let rings = rings.iter().map(|ring| ids(ring.iter().copied())).collect();
        map.push(at.to_string(), rings).expect("rings");
    }
    (map, Scene::from_points2(points).expect("finite"))
}
