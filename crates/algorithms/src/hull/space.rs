//! Convex hulls of points of space.

use std::collections::HashMap;

use predicament_predicates::{Predicates, Scene, Sign, Vertex};

use super::first::AXES;
use super::order::lexicographic;
use super::planted::Planted;
use super::scratch::Scratch;
use super::{Hull3, divide, faces, incremental};
use crate::planted::Honest;

/// How the hull of points of space is found.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub enum SpaceMethod {
    /// Points are inserted in random order, which is the same each time; a conflict graph knows who is outside.
    #[default]
    Incremental,
    /// The points are sorted; the half-edge meshes of both halves are stitched together by the faces that touch both.
    Divide,
}

/// The convex hull of the scene's vertices.
#[must_use]
pub fn hull3d(session: &dyn Predicates, method: SpaceMethod) -> Hull3 {
    hull3d_planted::<Honest>(session, method)
}

/// [`hull3d`] with a planted fault.
#[must_use]
pub fn hull3d_planted<F: Planted>(session: &dyn Predicates, method: SpaceMethod) -> Hull3 {
    let scene = session.scene();
    let vertices: Vec<Vertex> = scene.vertices().collect();
    let mut scratch = Scratch::new(scene.len());
    let mut hull = match method {
        SpaceMethod::Incremental => {
            let mut hull = incremental::hull::<F>(session, &mut scratch, &vertices);
            name_by_smallest(session, &mut hull);
            hull
        }
        SpaceMethod::Divide => divide::hull::<F>(session, &mut scratch, &vertices),
    };
    hull.vertices.sort_unstable();
    for face in &mut hull.faces {
        let smallest = (0..face.len()).min_by_key(|&at| face[at]).unwrap_or(0);
        face.rotate_left(smallest);
    }
    hull.faces.sort_unstable();
    hull
}

/// What is equal where coordinates are: zeros of either sign are.
fn place(scene: &Scene, v: Vertex) -> [u64; 3] {
    scene.point3(v).map(|x| (x + 0.0).to_bits())
}

/// Names the vertices of a hull by the smallest index at their place, where the session sees them in one place.
fn name_by_smallest(session: &dyn Predicates, hull: &mut Hull3) {
    let scene = session.scene();
    // Only looked up, never iterated: its order reaches no output.
    let mut smallest: HashMap<[u64; 3], Vertex> = hull.vertices.iter().map(|&v| (place(scene, v), v)).collect();
    let last = hull.vertices.iter().max().copied();
    let mut is_other = false;
    for v in scene.vertices().take_while(|&v| Some(v) < last) {
        if let Some(found) = smallest.get_mut(&place(scene, v))
            && v < *found
            && lexicographic(session, &AXES, v, *found) == Sign::Zero
        {
            *found = v;
            is_other = true;
        }
    }
    if is_other {
        let name = |v: &mut Vertex| {
            let other = smallest.get(&place(scene, *v)).copied().unwrap_or(*v);
            if lexicographic(session, &AXES, other, *v) == Sign::Zero {
                *v = other;
            }
        };
        hull.vertices.iter_mut().for_each(name);
        hull.faces.iter_mut().flatten().for_each(name);
        if !hull.faces.is_empty() {
            hull.vertices = faces::corners(&hull.faces);
        }
    }
}
