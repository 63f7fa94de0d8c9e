//! A filter for points of the plane that are certainly not vertices of the hull.
//!
//! The extreme points in eight directions make an octagon; a point strictly left of all its edges is inside. The
//! octagon is found by rounded coordinates and need not be convex. A closed polyline winds around any point strictly
//! left of each of its edges, so the point is inside the hull of the polyline's vertices. So signs alone decide.

use predicament_predicates::{Axis, Plane, Predicates, Scene, Sign, Vertex};

/// The number of points in a batch of queries: the points and their signs fit into a near cache.
const CHUNK: usize = 2048;
/// The minimum number of points for which the filter saves time.
const FEW: usize = 64;

/// The vertices of a plane scene that are not inside the octagon, unsorted.
pub(super) fn outer(session: &dyn Predicates) -> Vec<Vertex> {
    let scene = session.scene();
    let all: Vec<Vertex> = scene.vertices().collect();
    let ring = octagon(scene);
    if all.len() < FEW || ring.len() < 3 {
        return all;
    }
    let mut outer = ring.clone();
    let mut inside = Vec::with_capacity(CHUNK);
    let mut signs = vec![Sign::Zero; CHUNK];
    let mut own = ring.clone();
    own.sort_unstable();
    let mut rest = &all[..];
    // A query must not name a vertex twice, so batches leave out the octagon's own vertices.
    for corner in own.into_iter().map(Some).chain([None]) {
        let end = corner.map_or(rest.len(), |corner| rest.partition_point(|&v| v < corner));
        let (stretch, after) = rest.split_at(end);
        rest = after.get(usize::from(corner.is_some())..).unwrap_or(&[]);
        for chunk in stretch.chunks(CHUNK) {
            inside.clear();
            inside.extend_from_slice(chunk);
            for (at, &a) in ring.iter().enumerate() {
                let b = ring[(at + 1) % ring.len()];
                let signs = &mut signs[..inside.len()];
                session.orient2d_line(Plane::Xy, [a, b], &inside, signs);
                let mut kept = 0;
                for at in 0..inside.len() {
                    let v = inside[at];
                    if signs[at] == Sign::Positive {
                        inside[kept] = v;
                        kept += 1;
                    } else {
                        outer.push(v);
                    }
                }
                inside.truncate(kept);
            }
        }
    }
    outer
}

/// The extreme vertices in eight directions, counterclockwise, each once.
fn octagon(scene: &Scene) -> Vec<Vertex> {
    if scene.is_empty() {
        return Vec::new();
    }
    let mut most = [f64::NEG_INFINITY; 8];
    let mut found = [Vertex::input(0); 8];
    for (at, point) in scene.coordinates().chunks_exact(2).enumerate() {
        let [x, y] = [point[0], point[1]];
        for (place, value) in [x, x + y, y, y - x, -x, -x - y, -y, x - y].into_iter().enumerate() {
            if value > most[place] {
                most[place] = value;
                found[place] = Vertex::input(at);
            }
        }
    }
    let mut ring: Vec<Vertex> = Vec::with_capacity(8);
    let coordinates = |v: Vertex| [Axis::X, Axis::Y].map(|axis| scene.coordinate(axis, v));
    for v in found {
        if ring.iter().all(|&other| coordinates(other) != coordinates(v)) {
            ring.push(v);
        }
    }
    ring
}
