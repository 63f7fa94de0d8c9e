//! Points at one place: a program may use any of them.

use std::collections::HashMap;

use predicament_predicates::{Scene, Vertex};

/// For each point of a scene, the smallest point at its place.
#[must_use]
pub fn smallest_at_each_place(scene: &Scene) -> Vec<Vertex> {
    let dimension = scene.dimension().count();
    // Zeros of either sign are one place.
    let place = |v: Vertex| -> [u64; 3] {
        let point = scene.point(v);
        std::array::from_fn(|axis| if axis < dimension { (point[axis] + 0.0).to_bits() } else { 0 })
    };
    let mut at: HashMap<[u64; 3], Vertex> = HashMap::with_capacity(scene.len());
    scene.vertices().map(|v| *at.entry(place(v)).or_insert(v)).collect()
}
