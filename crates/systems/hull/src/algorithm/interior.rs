//! Throwing away points of the plane that are certainly no vertices of the hull.
//!
//! The extreme points in eight directions make an octagon; what is strictly left of all of its edges is inside. The
//! octagon is found by rounded coordinates and need not be convex: a point strictly left of each edge of a closed line
//! has the line wound around it, and is inside of the hull of the line's vertices. So signs alone decide.

use predicament_predicates::{Axis, Plane, Predicates, Scene, Sign, Vertex};

/// Points that are asked about at once: they and their signs fit into a near cache.
const CHUNK: usize = 2048;
/// With fewer points nothing is won.
const FEW: usize = 64;

/// The vertices of a plane scene that are not inside of the octagon, in no order.
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
    // No question names a vertex twice: the octagon's own vertices are between the stretches that are asked about.
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
