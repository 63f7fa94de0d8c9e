//! The judge of other programs' triangulations of polygons.
//!
//! A program gives triangles in either direction, and for each the number of its polygon if a scene has several. The
//! judge turns them counterclockwise. Then they must cover the polygon once. A program may leave out vertices in the
//! middle of an edge, and use any of several vertices at one place.

use predicament_judge::sign;
use predicament_predicates::{Declined, Query, Question, Scene, Sign, Vertex};
use predicament_tasks::replies::{
    Array, Arrays, Example, FORM, Form, Malformed, Part, Replies, Reply, SpoiledReply, Unjudged,
};
use predicament_tasks::{Asked, Case, Check, Class, Finding, Outcome};

use super::{Polygons, Triangulate, Triangulated};
use crate::checks::uncovered;

/// The judge.
pub(super) struct Judge;

/// The names of the answer's arrays.
const TRIANGLES: &str = "triangles";
const POLYGONS: &str = "polygons";

impl Replies<Triangulate> for Judge {
    fn parts(&self) -> &'static [Part] {
        const {
            &[
                Part::new(TRIANGLES, Form::Triangles, "the triangles of all polygons, in any order and direction"),
                Part::optional(POLYGONS, Form::Labels, "the polygon of each triangle, if there are several polygons"),
            ]
        }
    }

    fn example(&self) -> Example {
        Example {
            suites: "polygons",
            functions: &[
                ("python", include_str!("../engines/triangulate.py")),
                ("cpp", include_str!("../engines/triangulate.cpp")),
                ("rust", include_str!("../engines/triangulate.rs")),
                ("node", include_str!("../engines/triangulate.mjs")),
            ],
        }
    }

    /// Declines polygons in space: libraries triangulate in the plane.
    fn open(&self, scene: &Scene, _: &Polygons) -> Result<(), Declined> {
        match scene.dimension() {
            predicament_predicates::Dimension::Two => Ok(()),
            predicament_predicates::Dimension::Three => Err(Declined::scene("the polygons are in space")),
        }
    }

    fn judge(
        &self,
        case: &Case<'_, Triangulate>,
        asked: &Asked<'_>,
        reply: &Reply,
        outcome: &mut Outcome,
    ) -> Result<(), Unjudged> {
        let scene = case.scene();
        let triangles = reply.arrays.tuples::<3>(TRIANGLES, scene.len())?;
        let polygons = &case.truth.polygons;
        let mut found: Vec<Vec<[Vertex; 3]>> = vec![Vec::new(); polygons.len()];
        let of = match reply.arrays.get(POLYGONS) {
            None if polygons.len() == 1 => None,
            None => return Err(Malformed(format!("`{POLYGONS}` is missing, and there are several polygons")).into()),
            Some(_) => Some(reply.arrays.labels(POLYGONS, triangles.len())?),
        };
        for (at, mut triangle) in triangles.into_iter().enumerate() {
            let polygon = of.map_or(0, |of| of[at] as usize);
            let Some(found) = found.get_mut(polygon) else {
                return Err(Malformed(format!("`{POLYGONS}` has {polygon}, but there are {}", polygons.len())).into());
            };
            let (plane, _) = polygons[polygon].seen;
            if sign(scene, Question::Orient2d(plane), &triangle) == Sign::Negative {
                triangle.swap(1, 2);
            }
            found.push(triangle);
        }
        let most = asked.budget.findings_per_class;
        for (at, (triangles, truth)) in found.iter().zip(polygons).enumerate() {
            asked.watch.done(0)?;
            if truth.flaw.is_some() {
                continue;
            }
            let flaws = uncovered(&truth.polygon, triangles);
            if flaws.is_empty() {
                outcome.note(Class::Agree, most, || unreachable!("legal"));
            }
            for flaw in flaws {
                outcome.note(Class::Topology, most, || {
                    let vertices =
                        if flaw.vertices.is_empty() { vec![case.content.polygons[at][0][0]] } else { flaw.vertices };
                    let query = Query::of_task("triangulate", &vertices);
                    Finding::plain(Class::Topology, flaw.check, vec![query], flaw.got, flaw.truth)
                });
            }
        }
        Ok(())
    }

    fn reply_of(&self, _: &Scene, _: &Polygons, answer: &Triangulated) -> Arrays {
        let mut arrays = Arrays::default();
        arrays.add_vertices(TRIANGLES, answer.0.iter().flat_map(|found| found.triangles.as_flattened()));
        let numbers = (0..).zip(&answer.0).flat_map(|(at, found)| std::iter::repeat_n(at, found.triangles.len()));
        arrays.add(POLYGONS, Array::Ids(numbers.collect()));
        arrays
    }

    fn checks(&self) -> &'static [Check] {
        &[]
    }

    fn spoiled(&self) -> Vec<SpoiledReply<Triangulate>> {
        vec![SpoiledReply {
            name: "triangulate-reply-has-a-piece-of-a-triangle",
            what: "the last triangle has two corners",
            backend: "exact",
            caught_by: &[(Class::Topology, FORM)],
            spoil: |_, _, arrays| {
                if let Some(Array::Ids(ids)) = arrays.get_mut(TRIANGLES) {
                    ids.pop();
                }
            },
        }]
    }
}
