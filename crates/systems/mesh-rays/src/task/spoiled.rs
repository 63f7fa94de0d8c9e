//! Right answers with planted faults, which prove that the checks find faults that no backend has.

use super::checks::{HITS, ORDER, PARITY, PERTURBED};
use super::{MeshRays, RayHits, RayScene};
use crate::answer::{Feature, Groups, Hit};
use predicament_tasks::{Class, Spoiled};

pub(super) fn all() -> Vec<Spoiled<MeshRays>> {
    vec![
        Spoiled::new(
            "mesh-rays-lose-faces",
            "rays pass through faces without a hit",
            "exact",
            &[(Class::SignFlip, HITS)],
            |_, _, answer: &mut RayHits| keep(answer, is_degenerate),
        ),
        Spoiled::new(
            "mesh-rays-lose-vertices",
            "rays pass vertices and edges, and run along faces, without a hit",
            "exact",
            &[(Class::MissedZero, HITS)],
            |_, _, answer: &mut RayHits| keep(answer, |hit| !is_degenerate(hit)),
        ),
        Spoiled::new(
            "mesh-rays-hit-the-first-vertex",
            "each ray ends with a hit of the first vertex of the mesh",
            "exact",
            &[(Class::Overreach, HITS)],
            |_, content: &RayScene, answer: &mut RayHits| add_vertex(content, answer),
        ),
        Spoiled::new(
            "mesh-rays-told-apart",
            "hits at one place are reported as different",
            "exact",
            &[(Class::MissedZero, ORDER)],
            |_, _, answer: &mut RayHits| {
                each(answer, |groups| *groups = groups.iter().flatten().map(|&hit| vec![hit]).collect());
            },
        ),
        Spoiled::new(
            "mesh-rays-at-one-place",
            "all hits of a ray are at one place",
            "exact",
            &[(Class::Overreach, ORDER)],
            |_, _, answer: &mut RayHits| {
                each(answer, |groups| {
                    let mut all = groups.concat();
                    all.sort_unstable();
                    *groups = if all.is_empty() { Vec::new() } else { vec![all] };
                });
            },
        ),
        Spoiled::new(
            "mesh-rays-go-back",
            "the hits of each ray are in reverse order",
            "exact",
            &[(Class::SignFlip, ORDER)],
            |_, _, answer: &mut RayHits| each(answer, |groups| groups.reverse()),
        ),
        Spoiled::new(
            "mesh-rays-lose-the-last-perturbed",
            "if ties are broken, the last hit of each ray is lost",
            "sos",
            &[(Class::SignFlip, PERTURBED)],
            |_, _, answer: &mut RayHits| {
                each(answer, |groups| {
                    groups.pop();
                });
            },
        ),
        Spoiled::new(
            "mesh-rays-leave-ties",
            "each ray ends with a hit of the first vertex of the mesh, although ties are broken",
            "sos",
            &[(Class::Inconsistent, PERTURBED)],
            |_, content: &RayScene, answer: &mut RayHits| add_vertex(content, answer),
        ),
        Spoiled::new(
            "mesh-rays-miscount",
            "each ray crosses the mesh once more",
            "exact",
            &[(Class::Topology, PARITY)],
            |_, _, answer: &mut RayHits| {
                answer.0.iter_mut().for_each(|hits| hits.crossings = hits.crossings.map(|sum| sum + 1));
            },
        ),
    ]
}

fn is_degenerate(hit: &Hit) -> bool {
    hit.is_along || !matches!(hit.feature, Feature::Face(_))
}

fn each(answer: &mut RayHits, change: impl Fn(&mut Groups)) {
    answer.0.iter_mut().for_each(|hits| change(&mut hits.groups));
}

fn keep(answer: &mut RayHits, is_kept: impl Fn(&Hit) -> bool) {
    each(answer, |groups| {
        groups.iter_mut().for_each(|group| group.retain(&is_kept));
        groups.retain(|group| !group.is_empty());
    });
}

fn add_vertex(content: &RayScene, answer: &mut RayHits) {
    let hit = Hit { feature: Feature::Vertex(content.triangles[0][0]), is_along: false };
    each(answer, |groups| {
        if !groups.iter().flatten().any(|other| *other == hit) {
            groups.push(vec![hit]);
        }
    });
}
