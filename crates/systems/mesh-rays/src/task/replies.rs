//! The judge of other programs' hits.
//!
//! A program lists the triangles that each query hits, in the order of the hits along it. A triangle with its borders
//! is a closed set, and programs differ in what they say about borders. So:
//!
//! * a listed triangle has a point in common with the query, borders included, and none is listed twice;
//! * a triangle whose inside the query crosses is listed. Triangles that the query only touches, at a border or along
//!   their plane, may be listed or not;
//! * a query that begins or ends within a closed mesh has at least as many hits as the winding numbers at its ends
//!   differ: it does not leak out through an edge or a vertex;
//! * hits are in their order: places can be chosen from the common parts of the listed triangles and the query, none
//!   before the place of the hit before it. Hits at one place may have any order.

use std::collections::BTreeSet;

use predicament_predicates::{Query, Scene};
use predicament_tasks::replies::{
    Array, Arrays, Example, FORM, Form, Malformed, Part, Replies, Reply, SpoiledReply, Unjudged,
};
use predicament_tasks::{Asked, Case, Check, Class, Finding, Outcome};

use super::{MeshRays, RayHits, RayScene};
use crate::answer::{Feature, Hits, describe};
use crate::truth::{Known, is_in_order};

/// The judge.
pub(super) struct Judge;

/// The name of the answer's array.
const LISTS: &str = "hits";
const STRANGE: &str = "strange hit";
const STRANGE_MEANS: &str = "a program's list: its triangles meet the query, and each is listed once";
const LOST: &str = "lost hit";
const LOST_MEANS: &str = "a program's list: it has all triangles whose inside the query crosses";
const LEAK: &str = "leak";
const LEAK_MEANS: &str = "a program's list: a query from within a closed mesh does not leave it without a hit";
const LATE: &str = "late hit";
const LATE_MEANS: &str = "a program's list: hits are in their order along the query";

/// The triangles at each hit, in order: those around a vertex or an edge, too. Each is listed once.
pub(super) fn faces(content: &RayScene, hits: &Hits) -> Vec<u32> {
    let mut seen = BTreeSet::new();
    let mut all = Vec::new();
    for hit in hits.groups.iter().flatten() {
        let corners = match hit.feature {
            Feature::Vertex(v) => vec![v],
            Feature::Edge(ends) => ends.to_vec(),
            Feature::Face(face) => {
                all.extend(seen.insert(face).then_some(face));
                continue;
            }
        };
        for (face, of) in (0_u32..).zip(&content.triangles) {
            if corners.iter().all(|v| of.contains(v)) && seen.insert(face) {
                all.push(face);
            }
        }
    }
    all
}

impl Replies<MeshRays> for Judge {
    fn parts(&self) -> &'static [Part] {
        const {
            &[Part::new(
                LISTS,
                Form::Lists(&["faces"]),
                "for each ray the triangles that it hits, from its first point on",
            )]
        }
    }

    fn example(&self) -> Example {
        Example {
            suites: "mesh-rays",
            functions: &[
                ("python", include_str!("../engines/mesh_rays.py")),
                ("cpp", include_str!("../engines/mesh_rays.cpp")),
                ("rust", include_str!("../engines/mesh_rays.rs")),
                ("node", include_str!("../engines/mesh_rays.mjs")),
            ],
        }
    }

    fn judge(
        &self,
        case: &Case<'_, MeshRays>,
        asked: &Asked<'_>,
        reply: &Reply,
        outcome: &mut Outcome,
    ) -> Result<(), Unjudged> {
        let rays = &case.content.rays;
        let lists = reply.arrays.lists(LISTS, case.content.triangles.len())?;
        if lists.len() != rays.len() {
            let what = format!("`{LISTS}` has {} lists for {} rays", lists.len(), rays.len());
            return Err(Malformed(what).into());
        }
        for (at, list) in lists.iter().enumerate() {
            asked.watch.done(0)?;
            let Some(known) = case.truth.of(at) else { continue };
            let fault = fault(known, list);
            let class = if fault.is_some() { Class::Topology } else { Class::Agree };
            let (check, what) = fault.unwrap_or_default();
            outcome.note(class, asked.budget.findings_per_class, || {
                let query = Query::of_task("mesh-rays", &rays[at]);
                let got = list.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
                Finding::plain(class, check, vec![query], format!("{what}; listed: {got}"), describe(&known.groups))
            });
        }
        outcome.sampled = case.truth.sampled();
        Ok(())
    }

    fn reply_of(&self, _: &Scene, content: &RayScene, answer: &RayHits) -> Arrays {
        let lists: Vec<Vec<u32>> = answer.0.iter().map(|hits| faces(content, hits)).collect();
        let mut arrays = Arrays::default();
        arrays.add_lists(LISTS, &lists);
        arrays
    }

    fn checks(&self) -> &'static [Check] {
        const {
            &[
                Check::topology(STRANGE, STRANGE_MEANS),
                Check::topology(LOST, LOST_MEANS),
                Check::topology(LEAK, LEAK_MEANS),
                Check::topology(LATE, LATE_MEANS),
            ]
        }
    }

    fn spoiled(&self) -> Vec<SpoiledReply<MeshRays>> {
        vec![
            SpoiledReply {
                name: "mesh-rays-reply-loses-the-last",
                what: "of several hits of a ray the last one is missing",
                backend: "exact",
                caught_by: &[(Class::Topology, LOST)],
                spoil: |_, _, arrays| {
                    each(arrays, |list| {
                        if list.len() > 1 {
                            list.pop();
                        }
                    });
                },
            },
            SpoiledReply {
                name: "mesh-rays-reply-hits-all",
                what: "each ray hits the first triangles, too, if it has not listed them",
                backend: "exact",
                caught_by: &[(Class::Topology, STRANGE)],
                spoil: |_, content, arrays| {
                    let count = u32::try_from(content.triangles.len()).unwrap_or(u32::MAX);
                    each(arrays, |list| {
                        let others: Vec<u32> = (0..count.min(8)).filter(|face| !list.contains(face)).collect();
                        list.extend(others);
                    });
                },
            },
            SpoiledReply {
                name: "mesh-rays-reply-hits-twice",
                what: "the first hit of each ray is listed twice",
                backend: "exact",
                caught_by: &[(Class::Topology, STRANGE)],
                spoil: |_, _, arrays| each(arrays, |list| list.extend(list.first().copied())),
            },
            SpoiledReply {
                name: "mesh-rays-reply-leaks",
                what: "no ray hits anything",
                backend: "exact",
                caught_by: &[(Class::Topology, LEAK)],
                spoil: |_, _, arrays| each(arrays, Vec::clear),
            },
            SpoiledReply {
                name: "mesh-rays-reply-goes-back",
                what: "the hits of each ray are in reverse order",
                backend: "exact",
                caught_by: &[(Class::Topology, LATE)],
                spoil: |_, _, arrays| each(arrays, |list| list.reverse()),
            },
            SpoiledReply {
                name: "mesh-rays-reply-lacks-a-list",
                what: "the last ray has no list",
                backend: "exact",
                caught_by: &[(Class::Topology, FORM)],
                spoil: |_, _, arrays| {
                    if let Some(Array::Ids(starts)) = arrays.get_mut("hits.starts") {
                        starts.pop();
                    }
                },
            },
        ]
    }
}

/// The first fault of the list of a query.
fn fault(known: &Known, list: &[u32]) -> Option<(&'static str, String)> {
    if list.iter().collect::<BTreeSet<_>>().len() < list.len() {
        return Some((STRANGE, "a triangle is listed twice".to_owned()));
    }
    let is_met = |face: &u32| known.met.iter().any(|met| met.face == *face);
    if let Some(face) = list.iter().find(|face| !is_met(face)) {
        return Some((STRANGE, format!("{face} has no point in common with the query")));
    }
    if known.crossings.is_some_and(|sum| sum.unsigned_abs() > list.len() as u64) {
        return Some((LEAK, format!("{} hits", list.len())));
    }
    let crossed = known.groups.iter().flatten().filter(|hit| !hit.is_along);
    let mut faces = crossed.filter_map(|hit| if let Feature::Face(face) = hit.feature { Some(face) } else { None });
    let lost = faces.find(|face| !list.contains(face)).map(|face| (LOST, format!("{face} is not listed")));
    lost.or_else(|| (!is_in_order(list, known)).then(|| (LATE, "hits are out of order".to_owned())))
}

fn each(arrays: &mut Arrays, mut change: impl FnMut(&mut Vec<u32>)) {
    let Ok(lists) = arrays.lists(LISTS, usize::MAX) else { return };
    let mut lists: Vec<Vec<u32>> = lists.into_iter().map(<[u32]>::to_vec).collect();
    lists.iter_mut().for_each(&mut change);
    arrays.remove(LISTS);
    arrays.add_lists(LISTS, &lists);
}
