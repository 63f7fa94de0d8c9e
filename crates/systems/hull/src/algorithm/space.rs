//! Convex hulls of points of space.

use std::collections::HashMap;

use predicament_grid::parallel;
use predicament_predicates::{Predicates, Scene, Sign, Vertex};

use super::first::AXES;
use super::order::lexicographic;
use super::scratch::Scratch;
use super::{Hull3, PIECE, divide, incremental, middle, parts};

/// The methods for hulls in space.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Default, Debug)]
pub enum SpaceMethod {
    /// Drops points in a box in the middle, and points that are not vertices of the hull of their part. Inserts the
    /// others in a fixed random order; a conflict graph holds the outside points.
    #[default]
    Incremental,
    /// Divide and conquer: sorts the points, and stitches the half-edge meshes of both halves by the faces that touch
    /// both.
    Divide,
}

/// The convex hull of the scene's vertices.
#[must_use]
pub fn hull3d(session: &dyn Predicates, method: SpaceMethod) -> Hull3 {
    let scene = session.scene();
    let mut scratch = Scratch::new(scene.len());
    let mut hull = match method {
        SpaceMethod::Incremental => {
            let vertices = parts::survivors(session, middle::outer(session, &mut scratch));
            let mut hull = incremental::hull(session, &mut scratch, &vertices);
            name_by_smallest(session, &mut hull);
            hull
        }
        SpaceMethod::Divide => {
            let vertices: Vec<Vertex> = scene.vertices().collect();
            divide::hull(session, &mut scratch, &vertices)
        }
    };
    hull.vertices.sort_unstable();
    for face in &mut hull.faces {
        let smallest = (0..face.len()).min_by_key(|&at| face[at]).unwrap_or(0);
        face.rotate_left(smallest);
    }
    hull.faces.sort_unstable();
    hull
}

/// The key of a place: equal if and only if the coordinates are, with −0 equal to +0.
fn place(scene: &Scene, v: Vertex) -> [u64; 3] {
    scene.point3(v).map(|x| (x + 0.0).to_bits())
}

/// Renames each vertex of a hull to the smallest index at its place, if the session sees them in one place. A point in
/// the place of a vertex is not outside of any face, so it is not a vertex itself.
fn name_by_smallest(session: &dyn Predicates, hull: &mut Hull3) {
    let scene = session.scene();
    let Some(last) = hull.vertices.iter().max().copied() else { return };
    let mut is_vertex = vec![false; last.index() + 1];
    hull.vertices.iter().for_each(|v| is_vertex[v.index()] = true);
    let filter = Filter::of(hull.vertices.len(), hull.vertices.iter().map(|&v| place(scene, v)));
    let is_candidate = |v: &Vertex| !is_vertex[v.index()] && filter.may_have(place(scene, *v));
    let candidates = parallel::each(last.index().div_ceil(PIECE), &|piece| {
        let piece = (piece * PIECE..last.index().min((piece + 1) * PIECE)).map(Vertex::input);
        piece.filter(is_candidate).collect::<Vec<Vertex>>()
    })
    .concat();
    if candidates.is_empty() {
        return;
    }
    // Only looked up, never iterated: its order does not affect the output.
    let of_place: HashMap<[u64; 3], Vertex> = hull.vertices.iter().map(|&v| (place(scene, v), v)).collect();
    let mut smallest: HashMap<Vertex, Vertex> = HashMap::new();
    for v in candidates {
        if let Some(&named) = of_place.get(&place(scene, v))
            && v < named
            && lexicographic(session, &AXES, v, named) == Sign::Zero
        {
            // The first index is the smallest.
            smallest.entry(named).or_insert(v);
        }
    }
    let name = |v: &mut Vertex| *v = smallest.get(v).copied().unwrap_or(*v);
    hull.vertices.iter_mut().for_each(name);
    if !smallest.is_empty() {
        hull.faces.iter_mut().flatten().for_each(name);
    }
}

/// A filter for places, with one bit per hash value: it rejects most places outside a set at once.
struct Filter {
    bits: Vec<bool>,
}

impl Filter {
    fn of(count: usize, places: impl Iterator<Item = [u64; 3]>) -> Filter {
        let mut filter = Filter { bits: vec![false; (16 * count).next_power_of_two()] };
        for place in places {
            let at = filter.at(place);
            filter.bits[at] = true;
        }
        filter
    }

    fn at(&self, place: [u64; 3]) -> usize {
        let hash =
            place.into_iter().fold(0_u64, |hash, x| (hash ^ x).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(29));
        usize::try_from(hash >> 20).unwrap_or(0) & (self.bits.len() - 1)
    }

    fn may_have(&self, place: [u64; 3]) -> bool {
        self.bits[self.at(place)]
    }
}
