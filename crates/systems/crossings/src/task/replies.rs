//! The judge of other programs' crossings of segments.
//!
//! A program lists the segments that cross each segment, in the order of the crossings along it. All that is decided by
//! linear equations in rationals ([`common`]):
//!
//! * a listed segment has a point in common with the segment, and none is listed twice;
//! * all segments that cross it are listed: their inner points meet in one point;
//! * segments that only touch it, at an end or along a part, may be listed or not, but by both or by neither;
//! * crossings are in their order: points can be chosen from what the listed segments have in common with the segment,
//!   none of them before the one before it. Crossings at one place may have any order.

use std::collections::BTreeSet;

use predicament_predicates::{Query, Scene};
use predicament_tasks::replies::{
    Array, Arrays, Example, FORM, Form, Malformed, Part, Replies, Reply, SpoiledReply, Unjudged,
};
use predicament_tasks::{Asked, Case, Check, Class, Finding, Outcome};
use rug::Rational;

use super::{Crossed, Crossings, Segments, describe};
use crate::truth::common;

/// The judge.
pub(super) struct Judge;

/// The name of the answer's array.
const LISTS: &str = "crossings";
/// The check of listed segments.
const STRANGE: &str = "strange crossing";
const STRANGE_MEANS: &str = "a program's list: its segments meet the segment, and each is listed once, by both";
/// The check of segments that are not listed.
const LOST: &str = "lost crossing";
const LOST_MEANS: &str = "a program's list: it has all segments that cross the segment";
/// The check of the order.
const ORDER: &str = "order of crossings";
const ORDER_MEANS: &str = "a program's list: crossings are in their order along the segment";

impl Replies<Crossings> for Judge {
    fn parts(&self) -> &'static [Part] {
        const {
            &[Part::new(
                LISTS,
                Form::Lists(&["crossed_by"]),
                "for each segment the numbers of those that cross it, from its first end on",
            )]
        }
    }

    fn example(&self) -> Example {
        Example {
            suites: "crossings",
            functions: &[
                ("python", include_str!("../engines/crossings.py")),
                ("cpp", include_str!("../engines/crossings.cpp")),
                ("rust", include_str!("../engines/crossings.rs")),
                ("node", include_str!("../engines/crossings.mjs")),
            ],
        }
    }

    fn judge(
        &self,
        case: &Case<'_, Crossings>,
        asked: &Asked<'_>,
        reply: &Reply,
        outcome: &mut Outcome,
    ) -> Result<(), Unjudged> {
        let (scene, segments) = (case.scene(), &case.content.0);
        let lists = reply.arrays.lists(LISTS, segments.len())?;
        if lists.len() != segments.len() {
            let what = format!("`{LISTS}` has {} lists for {} segments", lists.len(), segments.len());
            return Err(Malformed(what).into());
        }
        let sets: Vec<BTreeSet<u32>> = lists.iter().map(|list| list.iter().copied().collect()).collect();
        for (at, (list, truth)) in lists.iter().zip(&case.truth).enumerate() {
            asked.watch.done(0)?;
            let (check, what) = match fault(scene, case.content, at, &sets, list) {
                Some((check, what)) => (check, what),
                None => match truth.iter().flatten().find(|other| !sets[at].contains(other)) {
                    Some(lost) => (LOST, format!("{lost} is not listed")),
                    None => ("", String::new()),
                },
            };
            let class = if check.is_empty() { Class::Agree } else { Class::Topology };
            outcome.note(class, asked.budget.findings_per_class, || {
                let query = Query::of_task("crossings", &segments[at]);
                let got = list.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
                Finding::plain(class, check, vec![query], format!("{what}; listed: {got}"), describe(truth))
            });
        }
        Ok(())
    }

    fn reply_of(&self, _: &Scene, _: &Segments, answer: &Crossed) -> Arrays {
        let lists: Vec<Vec<u32>> = answer.0.iter().map(|along| along.concat()).collect();
        let mut arrays = Arrays::default();
        arrays.add_lists(LISTS, &lists);
        arrays
    }

    fn checks(&self) -> &'static [Check] {
        const {
            &[
                Check::topology(STRANGE, STRANGE_MEANS),
                Check::topology(LOST, LOST_MEANS),
                Check::topology(ORDER, ORDER_MEANS),
            ]
        }
    }

    fn spoiled(&self) -> Vec<SpoiledReply<Crossings>> {
        vec![
            SpoiledReply {
                name: "crossings-reply-loses-the-last",
                what: "the last crossing of each segment is missing",
                backend: "exact",
                caught_by: &[(Class::Topology, LOST)],
                spoil: |_, _, arrays| each(arrays, |_, list| list.truncate(list.len().saturating_sub(1))),
            },
            SpoiledReply {
                name: "crossings-reply-lists-the-next-segment",
                what: "each segment lists the next one, too, if it has not listed it",
                backend: "exact",
                caught_by: &[(Class::Topology, STRANGE)],
                spoil: |_, content, arrays| {
                    let count = u32::try_from(content.0.len()).unwrap_or(u32::MAX);
                    each(arrays, |at, list| {
                        let next = (u32::try_from(at).unwrap_or(0) + 1) % count;
                        if !list.contains(&next) {
                            list.push(next);
                        }
                    });
                },
            },
            SpoiledReply {
                name: "crossings-reply-goes-back",
                what: "the crossings of each segment are in reverse order",
                backend: "exact",
                caught_by: &[(Class::Topology, ORDER)],
                spoil: |_, _, arrays| each(arrays, |_, list| list.reverse()),
            },
            SpoiledReply {
                name: "crossings-reply-lists-twice",
                what: "the first crossing of each segment is listed twice",
                backend: "exact",
                caught_by: &[(Class::Topology, STRANGE)],
                spoil: |_, _, arrays| each(arrays, |_, list| list.extend(list.first().copied())),
            },
            SpoiledReply {
                name: "crossings-reply-lacks-a-list",
                what: "the last segment has no list",
                backend: "exact",
                caught_by: &[(Class::Topology, FORM)],
                spoil: |_, _, arrays| {
                    if let Some(Array::Ids(starts)) = arrays.get_mut("crossings.starts") {
                        starts.pop();
                    }
                },
            },
        ]
    }
}

/// The first fault of the list of a segment, besides what it lacks.
fn fault(
    scene: &Scene,
    content: &Segments,
    at: usize,
    sets: &[BTreeSet<u32>],
    list: &[u32],
) -> Option<(&'static str, String)> {
    if sets[at].len() < list.len() {
        return Some((STRANGE, "a segment is listed twice".to_owned()));
    }
    // The farthest of the points that are chosen so far.
    let mut reached = Rational::new();
    let mut order = None;
    for &other in list {
        let met = (other as usize != at).then(|| common(scene, content.0[at], content.0[other as usize])).flatten();
        let Some([from, to]) = met else {
            return Some((STRANGE, format!("{other} has no point in common with it")));
        };
        if !u32::try_from(at).is_ok_and(|at| sets[other as usize].contains(&at)) {
            return Some((STRANGE, format!("{other} is listed, but does not list this segment")));
        }
        if to < reached {
            order = order.or(Some((ORDER, format!("{other} comes too late"))));
        }
        if from > reached {
            reached = from;
        }
    }
    order
}

fn each(arrays: &mut Arrays, mut change: impl FnMut(usize, &mut Vec<u32>)) {
    let Ok(lists) = arrays.lists(LISTS, usize::MAX) else { return };
    let mut lists: Vec<Vec<u32>> = lists.into_iter().map(<[u32]>::to_vec).collect();
    lists.iter_mut().enumerate().for_each(|(at, list)| change(at, list));
    arrays.remove(LISTS);
    arrays.add_lists(LISTS, &lists);
}
