//! Hulls in space: triangles of the surface, in any direction.
//!
//! # Why the checks are enough
//! Let all points span space. Each triangle with an area lies in a plane that has all points on one side (`supporting
//! plane`), so it is a part of the hull's boundary, which is a sphere. Directed outwards, the triangles meet along all
//! edges in both directions (`closed surface`): they are a cycle on that sphere, and cover it a whole number of times.
//! They cover one point of it once (`covered once`), so they cover all of it once.
//!
//! An edge counts as the pieces between the hull's vertices on it, and triangles without area are left out: a program
//! that fills the gap beside a point in the middle of an edge by such a triangle describes the same surface.

use std::collections::BTreeMap;

use predicament_judge::{rational, sign};
use predicament_predicates::{Declined, Plane, Question, Scene, Sign, Vertex};
use predicament_tasks::replies::{
    Array, Arrays, Example, Form, Part, Replies, Reply, SpoiledReply, Unjudged, note, smallest_at_each_place,
};
use predicament_tasks::{Asked, Budget, Case, Check, Class, Outcome};
use rug::Rational;

use crate::algorithm::SpaceMethod;
use crate::task::answer::{Hull3d, Surface};
use crate::task::cloud::Cloud;
use crate::truth::PAIRS;

/// The judge.
pub(crate) struct JudgeInSpace;

/// The name of the answer's array.
const TRIANGLES: &str = "triangles";
const SUPPORTING: &str = "supporting plane";
const CLOSED: &str = "closed surface";
const ONCE: &str = "covered once";

impl Replies<Hull3d> for JudgeInSpace {
    fn parts(&self) -> &'static [Part] {
        const { &[Part::new(TRIANGLES, Form::Triangles, "the triangles of the surface, in any order and direction")] }
    }

    fn example(&self) -> Example {
        Example {
            suites: "hulls -f hull3d",
            functions: &[
                ("python", include_str!("../../engines/hull3d.py")),
                ("cpp", include_str!("../../engines/hull3d.cpp")),
                ("rust", include_str!("../../engines/hull3d.rs")),
                ("node", include_str!("../../engines/hull3d.mjs")),
            ],
        }
    }

    /// Declines points in one plane: their hull has no surface that bounds a volume.
    fn open(&self, scene: &Scene, _: &Cloud<SpaceMethod>) -> Result<(), Declined> {
        match spanning(scene) {
            Some(_) => Ok(()),
            None => Err(Declined::scene("all points are in one plane")),
        }
    }

    fn judge(
        &self,
        case: &Case<'_, Hull3d>,
        asked: &Asked<'_>,
        reply: &Reply,
        outcome: &mut Outcome,
    ) -> Result<(), Unjudged> {
        let scene = case.scene();
        let first = smallest_at_each_place(scene);
        let mut triangles = reply.arrays.tuples::<3>(TRIANGLES, scene.len())?;
        triangles.iter_mut().for_each(|triangle| *triangle = triangle.map(|v| first[v.index()]));
        triangles.retain(|triangle| has_area(scene, *triangle));
        asked.watch.done(0)?;
        let Some(solid) = spanning(scene) else { return Ok(()) };
        let mut surface = Outward { scene, triangles };
        if let Some(what) = surface.turn(solid, PAIRS[usize::from(asked.budget.thorough)]) {
            note(outcome, Class::Topology, SUPPORTING, what, "all points are on one side of a triangle");
            return Ok(());
        }
        asked.watch.done(0)?;
        if let Some(what) = surface.open_edge() {
            note(outcome, Class::Topology, CLOSED, what, "at each edge, as many triangles come as go");
        } else if let Some(times) = surface.times(solid).filter(|&times| times != 1) {
            let got = format!("the surface is covered {times} times");
            note(outcome, Class::Topology, ONCE, got, "the surface is covered once");
        }
        Ok(())
    }

    fn reply_of(&self, _: &Scene, _: &Cloud<SpaceMethod>, answer: &Surface) -> Arrays {
        let mut arrays = Arrays::default();
        let fan = |face: &Vec<Vertex>| -> Vec<[Vertex; 3]> {
            face.windows(2).skip(1).map(|pair| [face[0], pair[0], pair[1]]).collect()
        };
        let triangles: Vec<[Vertex; 3]> = answer.0.faces.iter().flat_map(fan).collect();
        arrays.add_vertices(TRIANGLES, triangles.as_flattened());
        arrays
    }

    fn checks(&self) -> &'static [Check] {
        const {
            &[
                Check::topology(SUPPORTING, "a program's hull: all points are on one side of each triangle's plane"),
                Check::topology(CLOSED, "a program's hull: at each edge, as many triangles come as go"),
                Check::topology(ONCE, "a program's hull: its triangles cover the surface once"),
            ]
        }
    }

    fn spoiled(&self) -> Vec<SpoiledReply<Hull3d>> {
        vec![
            SpoiledReply {
                name: "hull3d-reply-loses-a-triangle",
                what: "the last triangle is missing",
                backend: "exact",
                caught_by: &[(Class::Topology, CLOSED)],
                spoil: |_, _, arrays| {
                    if let Some(Array::Ids(ids)) = arrays.get_mut(TRIANGLES) {
                        ids.truncate(ids.len().saturating_sub(3));
                    }
                },
            },
            SpoiledReply {
                name: "hull3d-reply-cuts-a-corner-off",
                what: "the first triangle's first corner is moved to a corner of another face",
                backend: "exact",
                caught_by: &[(Class::Topology, SUPPORTING)],
                spoil: |_, _, arrays| {
                    if let Some(Array::Ids(ids)) = arrays.get_mut(TRIANGLES)
                        && let [.., last] = ids[..]
                    {
                        ids[0] = last;
                    }
                },
            },
            SpoiledReply {
                name: "hull3d-reply-comes-twice",
                what: "all triangles are listed twice",
                backend: "exact",
                caught_by: &[(Class::Topology, ONCE)],
                spoil: |_, _, arrays| {
                    if let Some(Array::Ids(ids)) = arrays.get_mut(TRIANGLES) {
                        ids.extend_from_within(..);
                    }
                },
            },
        ]
    }
}

/// True if a triangle is not on one line.
fn has_area(scene: &Scene, triangle: [Vertex; 3]) -> bool {
    let planes = [Plane::Xy, Plane::Yz, Plane::Zx];
    planes.into_iter().any(|plane| !sign(scene, Question::Orient2d(plane), &triangle).is_zero())
}

/// Four points that are not in one plane.
fn spanning(scene: &Scene) -> Option<[Vertex; 4]> {
    let a = scene.vertices().next()?;
    let b = scene.vertices().find(|&b| scene.point(b) != scene.point(a))?;
    let c = scene.vertices().find(|&c| has_area(scene, [a, b, c]))?;
    let d = scene.vertices().find(|&d| !sign(scene, Question::Orient3d, &[a, b, c, d]).is_zero())?;
    Some([a, b, c, d])
}

/// The triangles of a surface.
struct Outward<'s> {
    scene: &'s Scene,
    triangles: Vec<[Vertex; 3]>,
}

impl Outward<'_> {
    /// Turns all triangles counterclockwise as seen from outside. Returns the first triangle with points on both sides,
    /// in words; of all pairs of a triangle and a point, an even sample is decided.
    fn turn(&mut self, solid: [Vertex; 4], pairs: usize) -> Option<String> {
        let scene = self.scene;
        let side = |[a, b, c]: [Vertex; 3], v: Vertex| sign(scene, Question::Orient3d, &[a, b, c, v]);
        let few = (pairs / scene.len().max(1)).max(1);
        let step = self.triangles.len().div_ceil(few);
        for at in 0..self.triangles.len() {
            let triangle = self.triangles[at];
            // A point in front of a triangle has a negative sign, a point behind it a positive one.
            let of_solid = solid.map(|v| side(triangle, v));
            let behind = of_solid.into_iter().find(|sign| !sign.is_zero()).unwrap_or(Sign::Positive);
            let wrong = |v: Vertex| (side(triangle, v) * behind == Sign::Negative).then_some(v);
            let mut sampled = if at % step == 0 { Some(scene.vertices()) } else { None }.into_iter().flatten();
            if let Some(v) = solid.into_iter().find_map(wrong).or_else(|| sampled.find_map(wrong)) {
                let [a, b, c] = triangle;
                return Some(format!("the triangle {a} {b} {c} has {v} on one side and other points on the other"));
            }
            if behind == Sign::Negative {
                self.triangles[at].swap(1, 2);
            }
        }
        // Every triangle against a sample of points: a few for each.
        let spread: Vec<usize> = Budget::spread(scene.len(), self.triangles.len().max(1), pairs).collect();
        for &[a, b, c] in &self.triangles {
            let outside = spread.iter().map(|&at| Vertex::input(at)).find(|&v| side([a, b, c], v) == Sign::Negative);
            if let Some(v) = outside {
                return Some(format!("{v} is in front of the triangle {a} {b} {c}"));
            }
        }
        None
    }

    /// The pieces of an edge between the surface's vertices on it.
    fn pieces(&self, [a, b]: [Vertex; 2], near: &[Vertex]) -> Vec<[Vertex; 2]> {
        let place = |v: Vertex| self.scene.point3(v);
        let (p, q) = (place(a), place(b));
        let is_on = |&v: &Vertex| {
            let at = place(v);
            v != a
                && v != b
                && (0..3).all(|i| p[i].min(q[i]) <= at[i] && at[i] <= p[i].max(q[i]))
                && !has_area(self.scene, [a, b, v])
        };
        let mut between: Vec<Vertex> = near.iter().copied().filter(is_on).collect();
        // All are on one line: the first coordinate in which its ends differ gives their order.
        let axis = (0..3).find(|&i| p[i] != q[i]).unwrap_or(0);
        let is_up = p[axis] < q[axis];
        between.sort_by(|&v, &w| {
            let order = place(v)[axis].total_cmp(&place(w)[axis]);
            if is_up { order } else { order.reverse() }
        });
        let all: Vec<Vertex> = [a].into_iter().chain(between).chain([b]).collect();
        all.windows(2).map(|pair| [pair[0], pair[1]]).collect()
    }

    /// The first edge at which more triangles come than go, in words.
    fn open_edge(&self) -> Option<String> {
        let balance = |edges: &mut dyn Iterator<Item = [Vertex; 2]>| {
            let mut uses: BTreeMap<[Vertex; 2], i64> = BTreeMap::new();
            for [a, b] in edges {
                *uses.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
            }
            uses.retain(|_, uses| *uses != 0);
            uses
        };
        let sides = self.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let open = balance(&mut sides.clone());
        if open.is_empty() && !self.triangles.is_empty() {
            return None;
        }
        // Edges whose uses do not add up may be cut by vertices on them: only their own ends can be such vertices.
        let mut ends: Vec<Vertex> = open.keys().flatten().copied().collect();
        ends.sort_unstable();
        ends.dedup();
        let cut = open.iter().flat_map(|(&[a, b], &uses)| {
            let way = if uses > 0 { [a, b] } else { [b, a] };
            let times = usize::try_from(uses.unsigned_abs()).unwrap_or(usize::MAX);
            let pieces = self.pieces(way, &ends);
            std::iter::repeat_n(pieces, times).flatten()
        });
        let open = balance(&mut cut.into_iter());
        match open.first_key_value() {
            Some(([a, b], _)) => Some(format!("{} edges are open, first that of {a} and {b}", open.len())),
            None => self.triangles.is_empty().then(|| "no triangle has an area".to_owned()),
        }
    }

    /// The number of triangles over the middle of the first triangle, as seen from inside; `None` if the ray there
    /// meets an edge of another triangle.
    fn times(&self, solid: [Vertex; 4]) -> Option<usize> {
        let point = |v: Vertex| self.scene.point3(v).map(rational);
        let middle = |of: &[Vertex]| {
            let points: Vec<[Rational; 3]> = of.iter().map(|&v| point(v)).collect();
            [0, 1, 2].map(|i: usize| {
                let sum: Rational = points.iter().map(|p| &p[i]).sum();
                sum / Rational::from(of.len())
            })
        };
        let less = |p: &[Rational; 3], q: &[Rational; 3]| [0, 1, 2].map(|i: usize| Rational::from(&p[i] - &q[i]));
        let from = middle(&solid);
        let along = less(&middle(self.triangles.first()?), &from);
        let volume = |u: &[Rational; 3], v: &[Rational; 3], w: &[Rational; 3]| {
            let minor = |i: usize, j: usize| Rational::from(&v[i] * &w[j]) - Rational::from(&v[j] * &w[i]);
            Rational::from(&u[0] * &minor(1, 2))
                + Rational::from(&u[1] * &minor(2, 0))
                + Rational::from(&u[2] * &minor(0, 1))
        };
        let mut times = 0;
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|v| less(&point(v), &from));
            let sides = [volume(&along, &a, &b), volume(&along, &b, &c), volume(&along, &c, &a)].map(|v| v.cmp0());
            // All triangles face outwards, and the ray starts inside: it leaves through those around it.
            if sides.iter().all(|side| side.is_gt()) {
                times += 1;
            } else if sides.iter().all(|side| side.is_ge()) {
                return None;
            }
        }
        Some(times)
    }
}
