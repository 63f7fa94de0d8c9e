//! The judges of other programs' convex hulls.
//!
//! A program may list a hull from any vertex on and in either direction, keep points in the middle of an edge or a
//! face, and use any of several points at one place.

mod plane;
mod space;

use predicament_predicates::{Scene, Vertex};
use std::collections::HashMap;

pub(super) use plane::JudgeInPlane;
pub(super) use space::JudgeInSpace;

/// For each point, the smallest point at its place.
fn smallest_at_each_place(scene: &Scene) -> Vec<Vertex> {
    let mut at: HashMap<Vec<u64>, Vertex> = HashMap::with_capacity(scene.len());
    // Zeros of either sign are one place.
    let place = |v: Vertex| scene.point(v).iter().map(|x| (x + 0.0).to_bits()).collect();
    scene.vertices().map(|v| *at.entry(place(v)).or_insert(v)).collect()
}
