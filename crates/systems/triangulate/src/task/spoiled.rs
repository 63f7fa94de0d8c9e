//! Right answers with planted faults: they test the checks that no backend's fault reaches.

use crate::algorithm::Contradiction;
use predicament_judge::sign;
use predicament_predicates::{Plane, Question, Scene, Vertex};

use super::{Polygons, Triangulate, Triangulated};
use crate::truth::seen;
use predicament_tasks::{Class, Spoiled};

pub(super) fn all() -> Vec<Spoiled<Triangulate>> {
    vec![
        Spoiled::new(
            "triangulate-repeats-a-corner",
            "the first triangle has a corner twice",
            "exact",
            &[(Class::Topology, "vertices")],
            |_, _, answer: &mut Triangulated| {
                for found in &mut answer.0 {
                    if let Some([a, _, c]) = found.triangles.first_mut() {
                        *c = *a;
                    }
                }
            },
        ),
        Spoiled::new(
            "triangulate-flips-flat-pairs",
            "two flat triangles with a common side have the other diagonal as their side",
            "sos",
            &[(Class::Topology, "perturbed triangles")],
            |scene: &Scene, content: &Polygons, answer: &mut Triangulated| {
                for (found, loops) in answer.0.iter_mut().zip(&content.polygons) {
                    let (plane, _) = seen(scene, loops);
                    flip(scene, Question::Orient2d(plane), &mut found.triangles);
                }
            },
        ),
        Spoiled::new(
            "triangulate-gives-up",
            "the algorithm stops at a polygon that has an ear",
            "exact",
            &[(Class::Topology, "a polygon has an ear")],
            |_, _, answer: &mut Triangulated| {
                answer.0.iter_mut().for_each(|found| found.broken = Some(Contradiction::Ear))
            },
        ),
        Spoiled::new(
            "triangulate-loses-a-triangle",
            "the last triangle is lost",
            "sos",
            &[
                (Class::Topology, "area"),
                (Class::Topology, "boundary"),
                (Class::Topology, "count"),
                (Class::Topology, "diagonals"),
            ],
            |_, _, answer: &mut Triangulated| {
                for found in &mut answer.0 {
                    found.triangles.pop();
                }
            },
        ),
        Spoiled::new(
            "triangulate-repeats-the-largest-triangle",
            "the largest triangle is listed twice, also where loops cross once they are perturbed",
            "sos",
            &[(Class::Topology, "area of the limit"), (Class::Topology, "inside of the limit")],
            |scene: &Scene, _, answer: &mut Triangulated| {
                let size = |triangle: &[Vertex; 3]| {
                    let [a, b, c] = triangle.map(|v| scene.point2(Plane::Xy, v));
                    ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs()
                };
                for found in &mut answer.0 {
                    let largest = found.triangles.iter().copied().max_by(|a, b| size(a).total_cmp(&size(b)));
                    found.triangles.extend(largest);
                }
            },
        ),
        Spoiled::new(
            "triangulate-turns-a-triangle",
            "the first triangle is turned over",
            "exact",
            &[(Class::Topology, "positive")],
            |_, _, answer: &mut Triangulated| {
                for triangle in answer.0.iter_mut().filter_map(|found| found.triangles.first_mut()) {
                    triangle.swap(1, 2);
                }
            },
        ),
        Spoiled::new(
            "triangulate-repeats-a-triangle",
            "the first triangle is listed twice",
            "exact",
            &[(Class::Topology, "overlap")],
            |_, _, answer: &mut Triangulated| {
                for found in &mut answer.0 {
                    found.triangles.extend(found.triangles.first().copied());
                }
            },
        ),
    ]
}

/// Flips the first two triangles with a common side whose corners are all in one line.
fn flip(scene: &Scene, question: Question, triangles: &mut [[Vertex; 3]]) {
    let is_flat = |corners: [Vertex; 3]| sign(scene, question, &corners).is_zero();
    let flat: Vec<usize> = (0..triangles.len()).filter(|&at| is_flat(triangles[at])).collect();
    for &i in &flat {
        for &j in flat.iter().filter(|&&j| j != i) {
            for turn in 0..3 {
                let [a, b, c] = [0, 1, 2].map(|corner| triangles[i][(corner + turn) % 3]);
                for other in 0..3 {
                    let [p, q, d] = [0, 1, 2].map(|corner| triangles[j][(corner + other) % 3]);
                    // The side from a to b of one triangle is the side from b to a of the other.
                    if p == b && q == a && d != c && is_flat([a, c, d]) {
                        triangles[i] = [a, d, c];
                        triangles[j] = [d, b, c];
                        return;
                    }
                }
            }
        }
    }
}
