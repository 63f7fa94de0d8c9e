//! Large sets of points of space: hulls of parts in parallel, whose vertices alone can be vertices of the whole hull.
//!
//! The parts depend on the vertices alone, so the answer of any session does not depend on the number of threads. If
//! most points of a sample are vertices of its hull, as on a sphere, parts would not drop enough of them to be worth
//! their time.

use predicament_grid::parallel;
use predicament_predicates::{Predicates, Vertex};

use super::incremental;
use super::scratch::Scratch;

/// The minimum number of vertices of a part.
const PART: usize = 1 << 14;
/// The maximum number of parts: the more there are, the more vertices survive.
const PARTS: usize = 8;
/// The number of vertices of the sample.
const SAMPLE: usize = 1 << 10;

/// The vertices that may be vertices of the hull, ascending; at least all that are.
pub(super) fn survivors(session: &dyn Predicates, vertices: Vec<Vertex>) -> Vec<Vertex> {
    if vertices.len() < 2 * PART {
        return vertices;
    }
    let sample: Vec<Vertex> = vertices.iter().copied().step_by(vertices.len() / SAMPLE).collect();
    match of_hull(session, &sample) {
        Some(few) if few.len() < sample.len() / 2 => {
            of_parts(session, &vertices, vertices.len().div_ceil(PARTS).max(PART)).unwrap_or(vertices)
        }
        _ => vertices,
    }
}

/// The vertices of the hulls of all parts, ascending; `None` if signs contradict each other.
fn of_parts(session: &dyn Predicates, vertices: &[Vertex], part: usize) -> Option<Vec<Vertex>> {
    let parts = parallel::pieces(vertices, part, &|part| of_hull(session, part));
    let mut all = parts.into_iter().collect::<Option<Vec<_>>>()?.concat();
    all.sort_unstable();
    Some(all)
}

/// The vertices of the hull of ascending vertices; `None` if signs contradict each other.
fn of_hull(session: &dyn Predicates, vertices: &[Vertex]) -> Option<Vec<Vertex>> {
    let end = vertices.last().map_or(0, |last| last.index() + 1);
    let hull = incremental::hull(session, &mut Scratch::new(end), vertices);
    hull.broken.is_none().then_some(hull.vertices)
}

#[cfg(test)]
mod tests {
    use predicament_exact::Exact;
    use predicament_predicates::{Backend, Off, Scene};

    use super::*;

    /// Points of a ball or of a cube, in a small grid, so that there are copies, lines and planes.
    fn scene(is_ball: bool) -> Scene {
        let mut state = 1_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            i32::try_from(state >> 33 & 63).expect("six bits") - 32
        };
        let mut points = Vec::new();
        while points.len() < 3000 {
            let [x, y, z] = [next(), next(), next()];
            if !is_ball || x * x + y * y + z * z <= 900 {
                points.push([x, y, z].map(f64::from));
            }
        }
        Scene::from_points3(&points).expect("finite")
    }

    #[test]
    fn parts_keep_every_vertex_of_the_hull() {
        for is_ball in [false, true] {
            let scene = scene(is_ball);
            let session = Exact.prepare(&scene, Off).expect("a scene");
            let all: Vec<Vertex> = scene.vertices().collect();
            let places = |vertices: Option<Vec<Vertex>>| {
                let of = |v| scene.point3(v).map(f64::to_bits);
                let mut places: Vec<_> = vertices.expect("exact signs").into_iter().map(of).collect();
                places.sort_unstable();
                places
            };
            let expected = places(of_hull(&session, &all));
            for part in [100, 999, 2999] {
                let kept = of_parts(&session, &all, part).expect("exact signs");
                assert!(kept.is_sorted() && kept.len() < all.len());
                assert_eq!(places(of_hull(&session, &kept)), expected, "parts of {part}");
            }
        }
    }
}
