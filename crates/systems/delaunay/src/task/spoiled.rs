//! Right answers with planted faults, which prove that the checks find faults that no backend has.

use std::collections::{BTreeMap, BTreeSet};

use crate::algorithm::{Contradiction, Delaunay2};
use predicament_judge::sign;
use predicament_predicates::{Construction, Plane, Question, Scene, Sign, Vertex};

use super::{Delaunay2d, Triangles};
use predicament_tasks::{Class, Spoiled};

pub(super) fn all() -> Vec<Spoiled<Delaunay2d>> {
    vec![
        Spoiled::new(
            "delaunay-repeats-a-corner",
            "the first triangle has a corner twice",
            "exact",
            &[(Class::Topology, "vertices")],
            |_, _, answer: &mut Triangles| {
                if let Some([a, _, c]) = answer.0.triangles.first_mut() {
                    *c = *a;
                }
            },
        ),
        Spoiled::new(
            "delaunay-chain-besides",
            "the corners of the first triangle are also a chain",
            "exact",
            &[(Class::Topology, "chain")],
            |_, _, answer: &mut Triangles| {
                answer.0.chain.extend(answer.0.triangles.first().into_iter().flatten().copied())
            },
        ),
        Spoiled::new(
            "delaunay-repeats-a-triangle",
            "the first triangle is listed twice",
            "exact",
            &[(Class::Topology, "edges"), (Class::Topology, "removal")],
            |_, _, answer: &mut Triangles| answer.0.triangles.extend(answer.0.triangles.first().copied()),
        ),
        Spoiled::new(
            "delaunay-with-a-hole",
            "a triangle without corners on the hull is lost",
            "exact",
            &[(Class::Topology, "hull")],
            |_, _, answer: &mut Triangles| {
                let hull: BTreeSet<Vertex> = hull(&answer.0).into_iter().flatten().collect();
                let inner = |triangle: &[Vertex; 3]| triangle.iter().all(|v| !hull.contains(v));
                if let Some(at) = answer.0.triangles.iter().position(inner) {
                    answer.0.triangles.remove(at);
                }
            },
        ),
        Spoiled::new(
            "delaunay-twice-around",
            "triangles around an inner vertex go to every second vertex of the hull",
            "exact",
            &[(Class::Topology, "wound once")],
            |_, _, answer: &mut Triangles| {
                let found = &mut answer.0;
                let next: BTreeMap<Vertex, Vertex> = hull(found).into_iter().map(|[a, b]| (a, b)).collect();
                let inner = found.triangles.as_flattened().iter().copied().find(|v| !next.contains_key(v));
                let (Some(centre), true) = (inner, next.len() >= 5 && !next.len().is_multiple_of(2)) else { return };
                let two_on = |v: &Vertex| next.get(next.get(v)?).copied();
                found.triangles = next.keys().filter_map(|&v| Some([centre, v, two_on(&v)?])).collect();
            },
        ),
        Spoiled::new(
            "delaunay-loses-a-crossing",
            "the first crossing is constructed from one line twice",
            "exact",
            &[(Class::Topology, "crossing")],
            |_, _, answer: &mut Triangles| {
                if let Some(Construction::Ssi([first, second])) = answer.0.crossings.first_mut() {
                    *second = *first;
                }
            },
        ),
        Spoiled::new(
            "delaunay-gives-up",
            "a walk toward a vertex is reported not to end",
            "exact",
            &[(Class::Topology, "a walk toward a vertex ends")],
            |_, _, answer: &mut Triangles| answer.0.broken = Some(Contradiction::Walk),
        ),
        Spoiled::new(
            "delaunay-forgets-copies",
            "vertices at the place of another vertex are not listed",
            "exact",
            &[(Class::Topology, "copies")],
            |_, _, answer: &mut Triangles| answer.0.copies.clear(),
        ),
        Spoiled::new(
            "delaunay-turns-a-triangle",
            "the first triangle is turned over",
            "exact",
            &[(Class::Topology, "positive")],
            |_, _, answer: &mut Triangles| {
                if let Some(triangle) = answer.0.triangles.first_mut() {
                    triangle.swap(1, 2);
                }
            },
        ),
        Spoiled::new(
            "delaunay-with-a-dent",
            "a triangle with an edge of the hull and an inner corner is lost",
            "exact",
            &[(Class::Topology, "convex"), (Class::Topology, "area")],
            |_, _, answer: &mut Triangles| {
                let border = hull(&answer.0);
                let ends: BTreeSet<Vertex> = border.iter().flatten().copied().collect();
                let is_dent = |&[a, b, c]: &[Vertex; 3]| {
                    let inner = [a, b, c].iter().filter(|v| !ends.contains(v)).count();
                    inner == 1 && [[a, b], [b, c], [c, a]].iter().any(|edge| border.contains(edge))
                };
                if let Some(at) = answer.0.triangles.iter().position(is_dent) {
                    answer.0.triangles.remove(at);
                }
            },
        ),
        Spoiled::new(
            "delaunay-crosses-a-constraint",
            "the first constraint between two triangles is replaced by the other diagonal",
            "exact",
            &[(Class::Topology, "constraint")],
            |_, _, answer: &mut Triangles| {
                let found = &mut answer.0;
                let constrained = found.constrained.clone();
                flip(&mut found.triangles, |[a, b], _| constrained.contains(&[a.min(b), a.max(b)]));
            },
        ),
        Spoiled::new(
            "delaunay-flips-an-edge",
            "two triangles that are not on one circle have the other diagonal as their edge",
            "exact",
            &[(Class::Topology, "empty circle")],
            |scene: &Scene, _, answer: &mut Triangles| {
                flip(&mut answer.0.triangles, |ends, tips| circle(scene, ends, tips) == Some(Sign::Negative));
            },
        ),
        Spoiled::new(
            "delaunay-turns-a-fan",
            "two triangles on one circle have the other diagonal as their edge",
            "exact",
            &[(Class::Topology, "fan")],
            |scene: &Scene, _, answer: &mut Triangles| {
                flip(&mut answer.0.triangles, |ends, tips| circle(scene, ends, tips) == Some(Sign::Zero));
            },
        ),
    ]
}

/// The edges of one triangle.
fn hull(found: &Delaunay2) -> Vec<[Vertex; 2]> {
    let all: BTreeSet<[Vertex; 2]> = found.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
    all.iter().copied().filter(|&[a, b]| !all.contains(&[b, a])).collect()
}

/// Replaces the first edge of two triangles that `is_wanted` accepts by the other diagonal. `is_wanted` gets the ends
/// and the other corners.
fn flip(triangles: &mut [[Vertex; 3]], is_wanted: impl Fn([Vertex; 2], [Vertex; 2]) -> bool) {
    let turns = |[a, b, c]: [Vertex; 3]| [[a, b, c], [b, c, a], [c, a, b]];
    let mut of: BTreeMap<[Vertex; 2], (usize, Vertex)> = BTreeMap::new();
    for (at, &triangle) in triangles.iter().enumerate() {
        of.extend(turns(triangle).map(|[a, b, c]| ([a, b], (at, c))));
    }
    let found = of.iter().find_map(|(&[a, b], &(i, c))| {
        let &(j, d) = of.get(&[b, a])?;
        is_wanted([a, b], [c, d]).then_some(([i, j], [a, b, c, d]))
    });
    if let Some(([i, j], [a, b, c, d])) = found {
        triangles[i] = [a, d, c];
        triangles[j] = [d, b, c];
    }
}

/// The incircle sign of the second of two corners beside an edge, for the circle of the edge and the first; `None` if
/// either diagonal is not an edge of two triangles with area.
fn circle(scene: &Scene, [a, b]: [Vertex; 2], [c, d]: [Vertex; 2]) -> Option<Sign> {
    if [a, b, c, d].iter().any(|v| v.is_constructed()) {
        return None;
    }
    let has_area = |corners: [Vertex; 3]| sign(scene, Question::Orient2d(Plane::Xy), &corners) == Sign::Positive;
    let is_convex = has_area([a, d, c]) && has_area([d, b, c]);
    is_convex.then(|| sign(scene, Question::Incircle, &[a, b, c, d]))
}
