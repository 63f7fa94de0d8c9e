//! The judge of other programs' contacts.
//!
//! A program lists pairs of simplices, each by the vertices of both. It may list the pairs of the largest simplices
//! that meet, as most libraries do, or the pairs of the hierarchy, each with the lowest ranks.
//!
//! * Each listed pair has a point in common.
//! * A pair of largest simplices that meet, and still do however little they are moved, is listed, or a pair of faces
//!   of both is.
//! * All other pairs that meet only touch: they may be listed or not.

use std::collections::BTreeSet;

use predicament_judge::boxes::{Boxes, Extent, extent};
use predicament_judge::contacts as judge;
use predicament_mesh::Complex;
use predicament_predicates::{Dimension, Scene, Vertex};
use predicament_tasks::replies::{
    Array, Arrays, Example, FORM, Form, Malformed, Part, Replies, Reply, SpoiledReply, Unjudged,
};
use predicament_tasks::{Asked, Case, Check, Class, Finding, Outcome};

use super::{Complexes, Contacts, Registered, query, vertices_of};
use crate::truth::{Pair, is_proper};

/// The judge of a dimension.
pub(super) struct Judge(Dimension);

pub(super) static IN_PLANE: Judge = Judge(Dimension::Two);
pub(super) static IN_SPACE: Judge = Judge(Dimension::Three);

/// The name of the answer's array.
const PAIRS: &str = "pairs";
/// The check of listed pairs.
const APART: &str = "pair apart";
const APART_MEANS: &str = "a program's list: both simplices of each pair have a common point";
/// The check of pairs that are not listed.
const LOST: &str = "lost pair";
const LOST_MEANS: &str =
    "a program's list: simplices that meet, and still do however little they are moved, are listed";

impl Replies<Contacts> for Judge {
    fn parts(&self) -> &'static [Part] {
        const {
            &[Part::new(
                PAIRS,
                Form::Lists(&["a", "b"]),
                "for each pair the vertices of both simplices, or of faces of them that meet",
            )]
        }
    }

    fn example(&self) -> Example {
        let functions: &[(&str, &str)] = match self.0 {
            Dimension::Two => &[
                ("python", include_str!("../engines/contacts2d.py")),
                ("cpp", include_str!("../engines/contacts2d.cpp")),
                ("rust", include_str!("../engines/contacts2d.rs")),
                ("node", include_str!("../engines/contacts2d.mjs")),
            ],
            Dimension::Three => &[
                ("python", include_str!("../engines/contacts3d.py")),
                ("cpp", include_str!("../engines/contacts3d.cpp")),
                ("rust", include_str!("../engines/contacts3d.rs")),
                ("node", include_str!("../engines/contacts3d.mjs")),
            ],
        };
        Example { suites: "contacts", functions }
    }

    fn judge(
        &self,
        case: &Case<'_, Contacts>,
        asked: &Asked<'_>,
        reply: &Reply,
        outcome: &mut Outcome,
    ) -> Result<(), Unjudged> {
        let (scene, content) = (case.scene(), case.content);
        let lists = reply.arrays.lists(PAIRS, scene.len())?;
        outcome.sampled = case.truth.sampled();
        let listed: BTreeSet<Pair> = lists.iter().map(|list| pair(content, list)).collect::<Result<_, _>>()?;
        let mut note = |class: Class, check: &str, pair: Pair| {
            outcome.note(class, asked.budget.findings_per_class, || {
                let [got, truth] = if check == LOST { ["not listed", "meet"] } else { ["listed", "apart"] };
                let queries = vec![query(scene, content, pair)];
                Finding::plain(class, check, queries, got.to_owned(), truth.to_owned())
            });
        };
        for &pair in &listed {
            asked.watch.done(0)?;
            let [s, t] = vertices_of(content, pair);
            let meets = judge::contact(scene, s, t).is_some() || judge::ended_by(scene, s, t).is_some();
            let class = if meets { Class::Agree } else { Class::Topology };
            note(class, APART, pair);
        }
        let [first, second] = content.both();
        let all = second.maximal();
        let index = Boxes::new(all.iter().map(|&t| around(scene, second.vertices_of(t))).collect());
        let mut near = Vec::new();
        for place in judge::sample(scene.dimension(), [first.maximal().len(), all.len()]).places() {
            asked.watch.done(0)?;
            let s = first.maximal()[place];
            let vertices = first.vertices_of(s);
            index.near(&around(scene, vertices), 0.0, &mut near);
            for t in near.iter().map(|&t| all[t as usize]) {
                let [of_s, of_t] = &case.truth.faces;
                let mut faces = of_s.of(s).flat_map(|s| of_t.of(t).map(move |t| [s, t]));
                if !faces.any(|pair| listed.contains(&pair)) && is_proper(scene, vertices, second.vertices_of(t)) {
                    note(Class::Topology, LOST, [s, t]);
                }
            }
        }
        Ok(())
    }

    fn reply_of(&self, _: &Scene, content: &Complexes, answer: &Registered) -> Arrays {
        let row = |pair: Pair| vertices_of(content, pair).concat().into_iter().map(number).collect();
        let rows: Vec<Vec<u32>> = answer.registered.iter().map(|contact| row([contact.a, contact.b])).collect();
        let mut arrays = Arrays::default();
        arrays.add_lists(PAIRS, &rows);
        arrays
    }

    fn checks(&self) -> &'static [Check] {
        const { &[Check::topology(APART, APART_MEANS), Check::topology(LOST, LOST_MEANS)] }
    }

    fn spoiled(&self) -> Vec<SpoiledReply<Contacts>> {
        vec![
            SpoiledReply {
                name: "contacts-reply-loses-pairs",
                what: "no pair is listed",
                backend: "exact",
                caught_by: &[(Class::Topology, LOST)],
                spoil: |_, _, arrays| {
                    arrays.remove(PAIRS);
                    arrays.add_lists::<Vec<u32>>(PAIRS, &[]);
                },
            },
            SpoiledReply {
                name: "contacts-reply-lists-vertices",
                what: "the first vertex of the first complex is said to meet the last one of the second",
                backend: "exact",
                caught_by: &[(Class::Topology, APART)],
                spoil: |_, content, arrays| {
                    let ends = (content.a.vertices().first(), content.b.vertices().last());
                    let Ok(lists) = arrays.lists(PAIRS, usize::MAX) else { return };
                    let mut lists: Vec<Vec<u32>> = lists.into_iter().map(<[u32]>::to_vec).collect();
                    if let (Some(&v), Some(&w)) = ends {
                        lists.push(vec![number(v), number(w)]);
                    }
                    arrays.remove(PAIRS);
                    arrays.add_lists(PAIRS, &lists);
                },
            },
            SpoiledReply {
                name: "contacts-reply-names-one-simplex",
                what: "the vertices of all pairs are in one list",
                backend: "exact",
                caught_by: &[(Class::Topology, FORM)],
                spoil: |_, _, arrays| {
                    if let Some(Array::Ids(starts)) = arrays.get_mut("pairs.starts")
                        && starts.len() > 3
                    {
                        starts.drain(1..starts.len() - 1);
                    }
                },
            },
        ]
    }
}

fn number(v: Vertex) -> u32 {
    u32::try_from(v.index()).expect("fewer than 2^32 points")
}

/// The pair with these vertices: those of the first complex, and those of the second.
fn pair(content: &Complexes, list: &[u32]) -> Result<Pair, Malformed> {
    let mut vertices: Vec<Vertex> = list.iter().map(|&id| Vertex::input(id as usize)).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let (s, t): (Vec<Vertex>, Vec<Vertex>) =
        vertices.into_iter().partition(|v| content.a.vertices().binary_search(v).is_ok());
    let find = |complex: &Complex, vertices: &[Vertex]| complex.find(vertices);
    match (find(&content.a, &s), find(&content.b, &t)) {
        (Some(s), Some(t)) => Ok([s, t]),
        _ => Err(Malformed(format!("`{PAIRS}` has {list:?}, which are not the vertices of a simplex of each complex"))),
    }
}

/// The box of a simplex; flat in the plane.
fn around(scene: &Scene, vertices: &[Vertex]) -> Extent<3> {
    let place = |&v: &Vertex| match scene.dimension() {
        Dimension::Two => [scene.point(v)[0], scene.point(v)[1], 0.0],
        Dimension::Three => scene.point3(v),
    };
    extent(vertices.iter().map(place))
}
