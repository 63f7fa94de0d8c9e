//! Hulls in the plane: brought into the form of this project's own hulls, then held against the same checks.

use std::cmp::Ordering;

use predicament_judge::sign;
use predicament_predicates::{Plane, Question, Scene, Sign, Vertex};
use predicament_tasks::replies::{
    Array, Arrays, Example, FORM, Form, Part, Replies, Reply, SpoiledReply, Unjudged, smallest_at_each_place,
};
use predicament_tasks::{Asked, Case, Check, Class, Outcome};

use crate::algorithm::PlaneMethod;
use crate::checks::plane_flaws;
use crate::task::answer::{Hull2d, Polygon};
use crate::task::cloud::{Cloud, Method};
use crate::task::judge::{Found, judge};

/// The judge.
pub(crate) struct JudgeInPlane;

/// The name of the answer's array.
const HULL: &str = "hull";

impl Replies<Hull2d> for JudgeInPlane {
    fn parts(&self) -> &'static [Part] {
        const { &[Part::new(HULL, Form::Loop, "the hull's vertices, one after the other in either direction")] }
    }

    fn example(&self) -> Example {
        Example {
            suites: "hulls -f hull2d",
            functions: &[
                ("python", include_str!("../../engines/hull2d.py")),
                ("cpp", include_str!("../../engines/hull2d.cpp")),
                ("rust", include_str!("../../engines/hull2d.rs")),
                ("node", include_str!("../../engines/hull2d.mjs")),
            ],
        }
    }

    fn judge(
        &self,
        case: &Case<'_, Hull2d>,
        asked: &Asked<'_>,
        reply: &Reply,
        outcome: &mut Outcome,
    ) -> Result<(), Unjudged> {
        let scene = case.scene();
        let first = smallest_at_each_place(scene);
        let corners = reply.arrays.tuples::<1>(HULL, scene.len())?;
        let hull = own_form(scene, corners.as_flattened().iter().map(|v| first[v.index()]).collect());
        let found = Found { vertices: &hull, broken: None, flaws: &|signs| plane_flaws(signs, &hull) };
        judge(PlaneMethod::TASK, case, asked, &found, outcome);
        Ok(())
    }

    fn reply_of(&self, _: &Scene, _: &Cloud<PlaneMethod>, answer: &Polygon) -> Arrays {
        let mut arrays = Arrays::default();
        arrays.add_vertices(HULL, &answer.0.vertices);
        arrays
    }

    fn checks(&self) -> &'static [Check] {
        &[]
    }

    fn spoiled(&self) -> Vec<SpoiledReply<Hull2d>> {
        vec![SpoiledReply {
            name: "hull2d-reply-has-a-label-for-a-point",
            what: "the hull has a corner −1",
            backend: "exact",
            caught_by: &[(Class::Topology, FORM)],
            spoil: |_, _, arrays| {
                if let Some(Array::Ids(ids)) = arrays.get_mut(HULL) {
                    ids.push(u32::MAX);
                }
            },
        }]
    }
}

/// A polygon counterclockwise from its leftmost vertex on, without repeated vertices and without vertices in the middle
/// of an edge.
fn own_form(scene: &Scene, corners: Vec<Vertex>) -> Vec<Vertex> {
    let place = |v: Vertex| scene.point2(Plane::Xy, v);
    let order = |v: Vertex, w: Vertex| place(v).partial_cmp(&place(w)).unwrap_or(Ordering::Equal);
    let mut hull: Vec<Vertex> = Vec::with_capacity(corners.len());
    let is_between = |[a, b, c]: [Vertex; 3]| {
        order(a, b) == order(b, c)
            && order(a, b) != Ordering::Equal
            && sign(scene, Question::Orient2d(Plane::Xy), &[a, b, c]) == Sign::Zero
    };
    let Some(leftmost) = (0..corners.len()).min_by(|&i, &j| order(corners[i], corners[j])) else { return hull };
    for &v in corners[leftmost..].iter().chain(&corners[..leftmost]) {
        if hull.last() == Some(&v) {
            continue;
        }
        while let [.., a, b] = hull[..]
            && is_between([a, b, v])
        {
            hull.pop();
        }
        hull.push(v);
    }
    // The end, where the polygon comes back to its first vertex, which is leftmost and in the middle of nothing.
    while hull.len() > 1 && hull.last() == hull.first() {
        hull.pop();
    }
    while let [first, .., a, b] = hull[..]
        && first != a
        && is_between([a, b, first])
    {
        hull.pop();
    }
    if let [first, second, .., last] = hull[..]
        && sign(scene, Question::Orient2d(Plane::Xy), &[last, first, second]) == Sign::Negative
    {
        hull[1..].reverse();
    }
    hull
}
