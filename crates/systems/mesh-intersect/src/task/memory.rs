//! Estimates of the memory of an overlay, before it runs.
//!
//! Points and pieces dominate: two meshes of n triangles can cross in n² places. The number of edges of one mesh that
//! pass through triangles of the other is estimated from even samples of both, in plain floating point; an error of a
//! few percent does not matter.

use predicament_mesh::MaterialMesh;
use predicament_predicates::{Declined, Scene, Vertex};

use super::content::TwoMeshes;
use predicament_tasks::{Halt, Refusal};

/// Bytes of an overlay for each given triangle: about twice the measured maximum for 10^7 triangles, 1.13 GiB.
const TRIANGLE: u64 = 250;
/// Bytes for each given triangle if all results are written: 377 as measured for two million.
pub(super) const FILES: u64 = 600;
/// Bytes for each point where an edge passes through a triangle, with the pieces around it.
const POINT: u64 = 2_000;
/// The maximum memory of an overlay, in bytes: 64 GiB.
const MOST: u64 = 1 << 36;
/// The numbers of edges and triangles that are sampled.
const SAMPLE: usize = 512;

type Point = [f64; 3];

/// Refuses two meshes whose overlay would take more memory than machines have.
///
/// # Errors
/// [`Halt::Refused`], with the estimate.
pub(super) fn affordable(scene: &Scene, content: &TwoMeshes) -> Result<(), Halt> {
    let bytes = estimate(scene, content, TRIANGLE);
    if bytes <= MOST {
        return Ok(());
    }
    let why = format!(
        "the overlay would need about {} GiB of memory; at most {} GiB are allowed: divide the meshes, or leave out \
         parts that do not cross",
        bytes >> 30,
        MOST >> 30
    );
    Err(Halt::Refused(Refusal { check: "memory", why: Declined::scene(why) }))
}

/// The approximate memory of an overlay, in bytes, with so many for each given triangle.
pub(super) fn estimate(scene: &Scene, content: &TwoMeshes, of_triangle: u64) -> u64 {
    let [first, second] = content.meshes.each_ref().map(|mesh| mesh.triangles().len() as u64);
    let given = of_triangle.saturating_mul(first + second);
    // Counted by sides of triangles; each edge has two.
    let pairs = 3 * first.saturating_mul(second);
    if pairs.saturating_mul(POINT) <= MOST {
        return given;
    }
    let [first, second] = content.meshes.each_ref();
    let points = crossings(scene, first, second).saturating_add(crossings(scene, second, first));
    given.saturating_add(points.saturating_mul(POINT))
}

/// The approximate number of passages of edges of one mesh through triangles of the other.
fn crossings(scene: &Scene, edges: &MaterialMesh, triangles: &MaterialMesh) -> u64 {
    // An odd step: similar triangles often come in pairs and fours.
    let step = |count: usize| count.div_ceil(SAMPLE) | 1;
    let steps = [edges, triangles].map(|mesh| step(mesh.triangles().len()));
    let corners = |mesh: &MaterialMesh, step: usize| -> Vec<[Point; 3]> {
        mesh.triangles().iter().step_by(step).map(|t| t.map(|v: Vertex| scene.point3(v))).collect()
    };
    let (edges, triangles) = (corners(edges, steps[0]), corners(triangles, steps[1]));
    let sides = edges.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let crossed: usize = sides.map(|side| triangles.iter().filter(|triangle| passes(side, triangle)).count()).sum();
    // Each edge is a side of two triangles.
    (crossed as u64 / 2).saturating_mul(steps[0] as u64).saturating_mul(steps[1] as u64)
}

/// True if an edge passes through a triangle, in floating point.
fn passes([p, q]: [Point; 2], [a, b, c]: &[Point; 3]) -> bool {
    let beside = |axis: usize| {
        let [a, b, c] = [a, b, c].map(|corner| corner[axis]);
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        p[axis].max(q[axis]) < low || high < p[axis].min(q[axis])
    };
    if (0..3).any(beside) {
        return false;
    }
    let above = |p: &Point| volume(a, b, c, p) > 0.0;
    let turns = [volume(&p, &q, a, b) > 0.0, volume(&p, &q, b, c) > 0.0, volume(&p, &q, c, a) > 0.0];
    above(&p) != above(&q) && turns == [turns[0]; 3]
}

fn volume(a: &Point, b: &Point, c: &Point, d: &Point) -> f64 {
    let [u, v, w] = [a, b, c].map(|p| [p[0] - d[0], p[1] - d[1], p[2] - d[2]]);
    u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0])
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use predicament_formats::bits::integer;

    use super::*;

    /// Needles along an axis; each crosses all needles along another axis.
    fn needles(count: usize, along: usize, points: &mut Vec<Point>) -> MaterialMesh {
        let first = points.len();
        for at in 0..count {
            let at = integer(i64::try_from(at).unwrap());
            let corners = [[-1.0, at, -0.5], [1e9, at, -0.5], [-1.0, at + 0.25, -0.5], [-1.0, at, 0.5]];
            points.extend(corners.map(|[x, y, z]| if along == 0 { [x, y, z] } else { [y, x, z + 0.25] }));
        }
        let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
        let triangles = (0..count).flat_map(|at| {
            let turned = faces.map(|[a, b, c]| if along == 0 { [a, b, c] } else { [a, c, b] });
            turned.map(|face| face.map(|corner: usize| Vertex::input(first + 4 * at + corner)))
        });
        MaterialMesh::of_closed(points.len(), triangles.collect()).unwrap()
    }

    fn pair(count: usize) -> (Scene, TwoMeshes) {
        let mut points = Vec::new();
        let meshes = [0, 1].map(|along| Arc::new(needles(count, along, &mut points)));
        (Scene::from_points3(&points).unwrap(), TwoMeshes { meshes, is_as_it_is: true })
    }

    #[test]
    fn what_crosses_everywhere_is_refused_before_it_is_tried() {
        let (scene, content) = pair(1_000);
        affordable(&scene, &content).unwrap();
        let (scene, content) = pair(20_000);
        let Err(Halt::Refused(refusal)) = affordable(&scene, &content) else { panic!("that is too much") };
        assert_eq!(refusal.check, "memory");
        assert!(refusal.to_string().contains("GiB of memory"), "{refusal}");
    }

    #[test]
    fn the_estimate_is_of_the_right_size() {
        // Three edges along each needle, which pass through about two faces of every other one.
        let (scene, content) = pair(2_000);
        let [first, second] = content.meshes.each_ref();
        let crossings = crossings(&scene, first, second);
        assert!((4_000_000..50_000_000).contains(&crossings), "{crossings}");
    }
}
