//! Right answers with planted faults, which prove that the checks find faults that no backend has.

use predicament_predicates::Vertex;
use predicament_tasks::{Class, Spoiled};

use super::checks::name;
use super::{CoverTask, Covers, HoleScene};
use crate::answer::{Cover, Reason};
use crate::checks::Law;

const fn catch(law: Law) -> (Class, &'static str) {
    (Class::Topology, name(law))
}

pub(super) fn all() -> Vec<Spoiled<CoverTask>> {
    vec![
        Spoiled::new(
            "cover-loses-a-triangle",
            "the last triangle of each cover is missing",
            "exact",
            const { &[catch(Law::Disk)] },
            |_, _, answer: &mut Covers| {
                each(answer, |_, triangles| {
                    triangles.pop();
                })
            },
        ),
        Spoiled::new(
            "cover-turned-over",
            "each cover is turned over",
            "exact",
            const { &[catch(Law::Disk)] },
            |_, _, answer: &mut Covers| each(answer, |_, triangles| triangles.iter_mut().for_each(|t| t.swap(0, 1))),
        ),
        Spoiled::new(
            "cover-has-a-triangle-twice",
            "the first triangle of each cover is there twice",
            "exact",
            const { &[catch(Law::Disk)] },
            |_, _, answer: &mut Covers| each(answer, |_, triangles| triangles.extend(triangles.first().copied())),
        ),
        Spoiled::new(
            "cover-by-fans",
            "each loop is covered by a fan from one of its points, also if the fan crosses the mesh, has triangles \
             without area, has edges of the mesh, or has a large area",
            "exact",
            const { &[catch(Law::Edge), catch(Law::Flat), catch(Law::Crossing), catch(Law::Least)] },
            |_, content: &HoleScene, answer: &mut Covers| {
                for (around, cover) in content.loops.iter().zip(&mut answer.0) {
                    if matches!(cover, Cover::Triangles(_) | Cover::Uncovered(Reason::Crosses)) {
                        *cover = Cover::Triangles(fan(around));
                    }
                }
            },
        ),
        Spoiled::new(
            "cover-gives-up",
            "a loop of more than three points is not covered",
            "exact",
            const { &[catch(Law::Uncovered)] },
            |_, content: &HoleScene, answer: &mut Covers| {
                for (around, cover) in content.loops.iter().zip(&mut answer.0) {
                    if around.len() > 3 {
                        *cover = Cover::Uncovered(Reason::Crosses);
                    }
                }
            },
        ),
    ]
}

/// Changes all covers.
fn each(answer: &mut Covers, change: impl Fn(usize, &mut Vec<[Vertex; 3]>)) {
    for (at, cover) in answer.0.iter_mut().enumerate() {
        if let Cover::Triangles(triangles) = cover {
            change(at, triangles);
        }
    }
}

/// The triangles of a loop with its last point.
fn fan(around: &[Vertex]) -> Vec<[Vertex; 3]> {
    let Some((&last, others)) = around.split_last() else { return Vec::new() };
    others.windows(2).map(|edge| [edge[0], edge[1], last]).collect()
}
