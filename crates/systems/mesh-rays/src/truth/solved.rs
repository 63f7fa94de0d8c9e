//! One query against all triangles, solved in integers.

use std::collections::BTreeMap;

use predicament_judge::rational;
use predicament_predicates::{Scene, Vertex};
use rug::{Integer, Rational};

use super::Known;
use crate::answer::{Extent, Feature, Groups, Hit, edge, edges};

type Vector = [Integer; 3];

/// A triangle that a query meets, and the part of the query that both have in common.
#[derive(Clone, Debug)]
pub struct Meeting {
    /// The triangle.
    pub face: u32,
    /// The first and the last common place: 0 is the first point of the query, 1 the second.
    pub part: [Rational; 2],
}

/// The mesh with integer coordinates.
pub(super) struct Solved<'c> {
    triangles: &'c [[Vertex; 3]],
    points: Vec<Vector>,
}

/// The common part of a query's line and a feature: from where, to where.
type Part = [Rational; 2];

impl<'c> Solved<'c> {
    pub(super) fn new(scene: &Scene, triangles: &'c [[Vertex; 3]]) -> Solved<'c> {
        let exact: Vec<[Rational; 3]> = scene.vertices().map(|v| scene.point3(v).map(rational)).collect();
        // All denominators are powers of two: the largest is a multiple of the others.
        let one = exact.iter().flatten().map(|x| x.denom().clone()).max().unwrap_or_else(|| Integer::from(1));
        let scaled = |x: &Rational| x.numer() * Integer::from(&one / x.denom());
        let points = exact.iter().map(|point| [0, 1, 2].map(|axis: usize| scaled(&point[axis]))).collect();
        Solved { triangles, points }
    }

    /// The hits of a query. The number of crossings is left open.
    pub(super) fn query(&self, [p, q]: [Vertex; 2], extent: Extent) -> Known {
        let from = &self.points[p.index()];
        let along = minus(&self.points[q.index()], from);
        if is_zero(&along) {
            // Two equal points have no line: the scene is refused.
            return Known::default();
        }
        let line = Line { solved: self, from, length: dot(&along, &along), along };
        let mut hits: BTreeMap<Feature, (Part, bool)> = BTreeMap::new();
        let (mut met, mut on_line) = (Vec::new(), Vec::new());
        let mut arms: BTreeMap<Vertex, Arm> = BTreeMap::new();
        for (face, &corners) in (0_u32..).zip(self.triangles) {
            let arms = corners.map(|v| arms.entry(v).or_insert_with(|| line.arm(v)).clone());
            let meets = line.meet(face, corners, &arms);
            let all: Vec<&Rational> = meets.iter().flat_map(|(_, part, _)| part).collect();
            if let (Some(first), Some(last)) = (all.iter().min(), all.iter().max()) {
                on_line.push(face);
                if let Some(part) = closed([(*first).clone(), (*last).clone()], extent) {
                    met.push(Meeting { face, part });
                }
            }
            hits.extend(meets.into_iter().map(|(feature, part, is_along)| (feature, (part, is_along))));
        }
        Known { groups: groups(hits, extent), met, on_line, crossings: None }
    }
}

/// A query's line.
struct Line<'s, 'c> {
    solved: &'s Solved<'c>,
    from: &'s Vector,
    along: Vector,
    /// The squared length of `along`.
    length: Integer,
}

/// A vertex as seen from a line: its difference to the line's first point, and its moment.
#[derive(Clone)]
struct Arm {
    reach: Vector,
    moment: Vector,
}

impl Line<'_, '_> {
    fn arm(&self, v: Vertex) -> Arm {
        let reach = minus(&self.solved.points[v.index()], self.from);
        let moment = cross(&reach, &self.along);
        Arm { reach, moment }
    }

    /// The place of a point with this difference to the first point of the line, over this weight.
    fn place(&self, reach: &Vector, weight: &Integer) -> Rational {
        Rational::from((dot(reach, &self.along), Integer::from(weight * &self.length)))
    }

    /// The features of a triangle that the line meets, each with the common part; true if that is an interval.
    fn meet(&self, face: u32, corners: [Vertex; 3], arms: &[Arm; 3]) -> Vec<(Feature, Part, bool)> {
        let one = Integer::from(1);
        let volumes = [[0, 1], [1, 2], [2, 0]].map(|[i, j]: [usize; 2]| dot(&arms[i].reach, &arms[j].moment));
        let has = |positive: bool| volumes.iter().any(|x| if positive { x.is_positive() } else { x.is_negative() });
        if has(true) && has(false) {
            return Vec::new();
        }
        if volumes.iter().all(|x| !x.is_zero()) {
            // The volume of an edge is the weight of the corner across from it.
            let sum: Integer = volumes.iter().sum();
            let weighted = |axis: usize| -> Integer {
                [2, 0, 1].iter().zip(&volumes).map(|(&at, volume)| Integer::from(&arms[at].reach[axis] * volume)).sum()
            };
            let t = self.place(&[0, 1, 2].map(weighted), &sum);
            return vec![(Feature::Face(face), [t.clone(), t], false)];
        }
        let mut found: Vec<(Feature, Part, bool)> = Vec::new();
        let is_on = [0, 1, 2].map(|at: usize| is_zero(&arms[at].moment));
        let places = [0, 1, 2].map(|at: usize| self.place(&arms[at].reach, &one));
        for at in (0..3).filter(|&at| is_on[at]) {
            found.push((Feature::Vertex(corners[at]), [places[at].clone(), places[at].clone()], false));
        }
        for (at, [u, v]) in edges(corners).into_iter().enumerate() {
            let next = (at + 1) % 3;
            if is_on[at] && is_on[next] {
                found.push((edge(u, v), ordered(&places[at], &places[next]), true));
            } else if volumes[at].is_zero() && dot(&arms[at].moment, &arms[next].moment).is_negative() {
                let t = self.between(&arms[at], &arms[next]);
                found.push((edge(u, v), [t.clone(), t], false));
            }
        }
        let normal = cross(&minus(&arms[1].reach, &arms[0].reach), &minus(&arms[2].reach, &arms[0].reach));
        if volumes.iter().all(Integer::is_zero) && !is_zero(&normal) {
            // The line is in the plane; it passes through the face if corners are on both sides of it.
            let sides = [0, 1, 2].map(|at: usize| dot(&arms[at].moment, &normal));
            let passes = sides.iter().any(Integer::is_positive) && sides.iter().any(Integer::is_negative);
            let ends: Vec<&Rational> = found.iter().filter(|found| !found.2).flat_map(|found| &found.1).collect();
            if let (true, Some(first), Some(last)) = (passes, ends.iter().min(), ends.iter().max()) {
                let part = [(*first).clone(), (*last).clone()];
                found.push((Feature::Face(face), part, true));
            }
        }
        found
    }

    /// The place at which the line crosses an edge in one plane with it: the moments of its ends are opposite.
    fn between(&self, u: &Arm, v: &Arm) -> Rational {
        let axis = (0..3).find(|&axis| !u.moment[axis].is_zero()).unwrap_or(0);
        let weight = Integer::from(&u.moment[axis] - &v.moment[axis]);
        let reach = [0, 1, 2].map(|i: usize| {
            Integer::from(&v.reach[i] * &u.moment[axis]) - Integer::from(&u.reach[i] * &v.moment[axis])
        });
        self.place(&reach, &weight)
    }
}

/// The part of a closed interval that the query has; `None` if it has nothing of it.
fn closed([first, last]: Part, extent: Extent) -> Option<Part> {
    let first = if extent.has_start() { first.max(Rational::new()) } else { first };
    let last = if extent.has_end() { last.min(Rational::from(1)) } else { last };
    (first <= last).then_some([first, last])
}

/// The groups of the hits that the query has.
fn groups(hits: BTreeMap<Feature, (Part, bool)>, extent: Extent) -> Groups {
    let mut sorted: Vec<(Rational, bool, Hit)> = Vec::new();
    for (feature, (part, is_along)) in hits {
        let Some([first, last]) = closed(part, extent) else { continue };
        // An open interval needs more than one of its places.
        if !is_along || first < last {
            sorted.push((first, is_along, Hit { feature, is_along }));
        }
    }
    sorted.sort();
    sorted.chunk_by(|a, b| a.0 == b.0 && a.1 == b.1).map(|group| group.iter().map(|(.., hit)| *hit).collect()).collect()
}

fn ordered(a: &Rational, b: &Rational) -> Part {
    if a <= b { [a.clone(), b.clone()] } else { [b.clone(), a.clone()] }
}

fn minus(u: &Vector, v: &Vector) -> Vector {
    [0, 1, 2].map(|axis: usize| Integer::from(&u[axis] - &v[axis]))
}

fn dot(u: &Vector, v: &Vector) -> Integer {
    u.iter().zip(v).map(|(x, y)| Integer::from(x * y)).sum()
}

fn cross(u: &Vector, v: &Vector) -> Vector {
    [[1, 2], [2, 0], [0, 1]].map(|[i, j]: [usize; 2]| Integer::from(&u[i] * &v[j]) - Integer::from(&u[j] * &v[i]))
}

fn is_zero(u: &Vector) -> bool {
    u.iter().all(Integer::is_zero)
}
