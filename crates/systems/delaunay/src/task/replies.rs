//! The judge of other programs' Delaunay triangulations.
//!
//! A program may cut cocircular points in any way, list corners in either direction, and use any of several points at
//! one place. The judge turns its triangles counterclockwise and takes the smallest point of each place; then the
//! [checks](crate::checks) apply, all but `fan`.

use predicament_hull::checks::{Flaw, Signs};
use predicament_judge::{Judged, sign};
use predicament_predicates::{Declined, Plane, Predicates, Question, Scene, Sign, Vertex};
use predicament_tasks::replies::{
    Array, Arrays, Example, FORM, Form, Part, Replies, Reply, SpoiledReply, Unjudged, smallest_at_each_place,
};
use predicament_tasks::{Asked, Case, Check, Class, Outcome};

use super::judge::note;
use super::{Delaunay2d, Sites, Triangles};
use crate::checks::{Cut, Found, flaws};
use crate::truth::PAIRS;

/// The judge.
pub(super) struct Judge;

/// The name of the answer's array.
const TRIANGLES: &str = "triangles";

impl Replies<Delaunay2d> for Judge {
    fn parts(&self) -> &'static [Part] {
        const { &[Part::new(TRIANGLES, Form::Triangles, "the triangles, in any order and direction")] }
    }

    fn example(&self) -> Example {
        Example {
            suites: "delaunay",
            functions: &[
                ("python", include_str!("../engines/delaunay2d.py")),
                ("cpp", include_str!("../engines/delaunay2d.cpp")),
                ("rust", include_str!("../engines/delaunay2d.rs")),
                ("node", include_str!("../engines/delaunay2d.mjs")),
            ],
        }
    }

    /// Declines constraints that cross: their crossing is not a point of the scene.
    fn open(&self, scene: &Scene, content: &Sites) -> Result<(), Declined> {
        let crosses = |one: &[Vertex; 2], other: &[Vertex; 2]| {
            let apart = |[a, b]: [Vertex; 2], [c, d]: [Vertex; 2]| {
                let side = |v: Vertex| sign(scene, Question::Orient2d(Plane::Xy), &[a, b, v]);
                side(c) * side(d) == Sign::Negative
            };
            apart(*one, *other) && apart(*other, *one)
        };
        let all = &content.constraints;
        let crossed = all.iter().enumerate().any(|(at, one)| all[..at].iter().any(|other| crosses(one, other)));
        if crossed {
            Err(Declined::scene("constraints cross, and programs answer with points of the scene"))
        } else {
            Ok(())
        }
    }

    fn judge(
        &self,
        case: &Case<'_, Delaunay2d>,
        asked: &Asked<'_>,
        reply: &Reply,
        outcome: &mut Outcome,
    ) -> Result<(), Unjudged> {
        let scene = case.scene();
        let first = smallest_at_each_place(scene);
        let canonical = |v: Vertex| first[v.index()];
        let mut triangles: Vec<[Vertex; 3]> = reply.arrays.tuples::<3>(TRIANGLES, scene.len())?;
        for triangle in &mut triangles {
            *triangle = triangle.map(canonical);
            if sign(scene, Question::Orient2d(Plane::Xy), triangle) == Sign::Negative {
                triangle.swap(1, 2);
            }
        }
        asked.watch.done(0)?;
        let copies: Vec<[Vertex; 2]> =
            scene.vertices().filter(|&v| canonical(v) != v).map(|v| [v, canonical(v)]).collect();
        let mut chain: Vec<Vertex> = Vec::new();
        if triangles.is_empty() {
            chain = scene.vertices().filter(|&v| canonical(v) == v).collect();
            chain.sort_by(|&v, &w| {
                let [v, w] = [v, w].map(|v| scene.point2(Plane::Xy, v));
                v.partial_cmp(&w).unwrap_or(std::cmp::Ordering::Equal)
            });
        }
        if let [first, .., last] = chain[..]
            && let Some(&v) =
                chain.iter().find(|&&v| !sign(scene, Question::Orient2d(Plane::Xy), &[first, last, v]).is_zero())
        {
            let what = "there are no triangles, but the points are not on one line".to_owned();
            note(outcome, &Flaw { check: "chain", places: 1, vertices: vec![first, last, v], what });
            return Ok(());
        }
        let exact = Judged::exact(scene);
        let pairs = PAIRS[usize::from(asked.budget.thorough)];
        let signs = Signs { exact: &exact as &dyn Predicates, perturbed: None, ties: 0, pairs };
        let constraints = &case.content.constraints;
        let found = Found { triangles: &triangles, chain: &chain, copies: &copies, constraints, cut: Cut::Anyhow };
        flaws(signs, found).iter().for_each(|flaw| note(outcome, flaw));
        Ok(())
    }

    fn reply_of(&self, _: &Scene, _: &Sites, answer: &Triangles) -> Arrays {
        let mut arrays = Arrays::default();
        arrays.add_vertices(TRIANGLES, answer.0.triangles.as_flattened());
        arrays
    }

    fn checks(&self) -> &'static [Check] {
        &[]
    }

    fn spoiled(&self) -> Vec<SpoiledReply<Delaunay2d>> {
        vec![
            SpoiledReply {
                name: "delaunay2d-reply-names-a-point-too-many",
                what: "a corner is the point after the last one",
                backend: "exact",
                caught_by: &[(Class::Topology, FORM)],
                spoil: |scene, _, arrays| {
                    if let Some(Array::Ids(ids)) = arrays.get_mut(TRIANGLES)
                        && let Some(last) = ids.last_mut()
                    {
                        *last = u32::try_from(scene.len()).unwrap_or(u32::MAX);
                    }
                },
            },
            SpoiledReply {
                name: "delaunay2d-reply-loses-a-triangle",
                what: "the triangle in the middle of the list is missing",
                backend: "exact",
                caught_by: &[(Class::Topology, "hull"), (Class::Topology, "area")],
                spoil: |_, _, arrays| {
                    if let Some(Array::Ids(ids)) = arrays.get_mut(TRIANGLES) {
                        let middle = ids.len() / 6 * 3;
                        ids.drain(middle..(middle + 3).min(ids.len()));
                    }
                },
            },
        ]
    }
}
