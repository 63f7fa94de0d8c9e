//! Answers with faults: what no fault in the algorithm reaches.

use std::collections::{BTreeMap, BTreeSet};

use predicament_algorithms::delaunay::Delaunay2;
use predicament_predicates::{Construction, Vertex};

use super::{Delaunay2d, Triangles};
use crate::{Class, Spoiled};

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
            "the corners of the first triangle are a chain too",
            "exact",
            &[(Class::Topology, "chain")],
            |_, _, answer: &mut Triangles| {
                answer.0.chain.extend(answer.0.triangles.first().into_iter().flatten().copied())
            },
        ),
        Spoiled::new(
            "delaunay-repeats-a-triangle",
            "the first triangle is there twice",
            "exact",
            &[(Class::Topology, "edges")],
            |_, _, answer: &mut Triangles| answer.0.triangles.extend(answer.0.triangles.first().copied()),
        ),
        Spoiled::new(
            "delaunay-with-a-hole",
            "a triangle whose corners are no ends of the hull is lost",
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
            "around a vertex inside, every second vertex of the hull follows",
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
            "the lines of the first crossing are one line",
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
            "a walk toward a vertex is said not to end",
            "exact",
            &[(Class::Topology, "a walk toward a vertex ends")],
            |_, _, answer: &mut Triangles| answer.0.broken = Some("a walk toward a vertex ends"),
        ),
    ]
}

/// The edges of one triangle.
fn hull(found: &Delaunay2) -> Vec<[Vertex; 2]> {
    let all: BTreeSet<[Vertex; 2]> = found.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
    all.iter().copied().filter(|&[a, b]| !all.contains(&[b, a])).collect()
}
