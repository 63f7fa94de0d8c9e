//! Triangles against the truth about their polygon.

use crate::checks::{Flat, Flaw, Polygon, flaws};
use predicament_judge::{Judged, sign};
use predicament_predicates::{
    Dimension, Plane, PredicateKind, Predicates, Query, Question, Scene, Sign, Vertex, ZeroMeaning,
};

use super::{Triangulate, Triangulated, words};
use predicament_tasks::{Asked, Case, Class, Finding, Outcome, Stop, Watch};

/// What is true about each polygon of a scene.
#[derive(Debug)]
pub struct Truth {
    /// In the scene's order.
    pub polygons: Vec<Polygon>,
    /// The plane in which each was looked at, and whether it is seen from behind there.
    pub seen: Vec<(Plane, bool)>,
}

impl Truth {
    /// The truth, polygon by polygon.
    ///
    /// # Errors
    /// [`Stop`] where the watch says so.
    pub fn new(scene: &Scene, polygons: &[Vec<Vec<Vertex>>], watch: &Watch) -> Result<Truth, Stop> {
        let mut truth = Truth { polygons: Vec::with_capacity(polygons.len()), seen: Vec::new() };
        for loops in polygons {
            let (plane, reversed) = seen(scene, loops);
            truth.polygons.push(Polygon::new(scene, plane, reversed, loops));
            truth.seen.push((plane, reversed));
            watch.done(1)?;
        }
        Ok(truth)
    }

    /// What was not looked at.
    pub fn sampled(&self) -> Option<String> {
        let all = self.polygons.len();
        let count = |is: &dyn Fn(&Polygon) -> bool| self.polygons.iter().filter(|polygon| is(polygon)).count();
        let wrong = count(&|polygon| self.is_left_out(polygon));
        let unknown = count(&|polygon| !polygon.touches().is_known);
        let mut said = Vec::new();
        if wrong > 0 {
            said.push(format!(
                "{wrong} of {all} regions are not judged: their rings cross, or pass along an edge twice"
            ));
        }
        if unknown > 0 {
            said.push(format!("of {unknown} of {all} polygons no two edges were compared: taken not to touch"));
        }
        (!said.is_empty()).then(|| said.join("; "))
    }

    /// Whether a region of a map is no polygon: what a single one is not is a finding.
    fn is_left_out(&self, polygon: &Polygon) -> bool {
        self.polygons.len() > 1 && polygon.fault().is_some()
    }
}

/// The first coordinate plane in which the face has area, and whether it is seen from behind there: the outer loop of
/// the first corner in order goes the right way.
pub(super) fn seen(scene: &Scene, loops: &[Vec<Vertex>]) -> (Plane, bool) {
    if scene.dimension() == Dimension::Two {
        return (Plane::Xy, false);
    }
    let planes = [Plane::Xy, Plane::Yz, Plane::Zx].into_iter();
    let turned = planes.filter_map(|plane| {
        let point = |v: Vertex| scene.point2(plane, v);
        let before = |a: Vertex, b: Vertex| point(a).partial_cmp(&point(b)) == Some(std::cmp::Ordering::Less);
        let outer = loops.iter().reduce(|one, other| {
            let first = |of: &[Vertex]| of.iter().copied().reduce(|a, b| if before(b, a) { b } else { a });
            if first(other).zip(first(one)).is_some_and(|(b, a)| before(b, a)) { other } else { one }
        })?;
        match area_sign(scene, plane, outer) {
            Sign::Zero => None,
            sign => Some((plane, sign == Sign::Negative)),
        }
    });
    turned.into_iter().next().unwrap_or((Plane::Xy, false))
}

/// The sign of the area of a loop in a plane: the turn at its first corner in order.
fn area_sign(scene: &Scene, plane: Plane, corners: &[Vertex]) -> Sign {
    let point = |at: usize| scene.point2(plane, corners[at % corners.len()]);
    let before = |a: usize, b: usize| point(a).partial_cmp(&point(b)) == Some(std::cmp::Ordering::Less);
    let Some(first) = (0..corners.len()).reduce(|a, b| if before(b, a) { b } else { a }) else { return Sign::Zero };
    let apart = |at: &usize| point(*at) != point(first);
    let count = corners.len();
    let next = (first + 1..first + count).find(apart).unwrap_or(first);
    let previous = (first + 1..first + count).rev().find(apart).unwrap_or(first);
    let turn = [previous, first, next].map(|at| corners[at % count]);
    if turn[0] == turn[2] { Sign::Zero } else { sign(scene, Question::Orient2d(plane), &turn) }
}

/// Judges the triangles of all polygons.
pub(super) fn judge(
    case: &Case<'_, Triangulate>,
    asked: &Asked<'_>,
    answer: &Triangulated,
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    let zero = asked.contract(PredicateKind::Orient2d).zero;
    let most = asked.budget.findings_per_class;
    for (at, (found, truth)) in answer.0.iter().zip(&case.truth.polygons).enumerate() {
        asked.watch.done(0)?;
        if case.truth.is_left_out(truth) {
            continue;
        }
        let (plane, reversed) = case.truth.seen[at];
        let ties = (zero == ZeroMeaning::Never).then(|| asked.backend.tie_judge()).flatten();
        let perturbed = ties.map(|ties| Perturbed { judged: Judged::perturbed(case.scene(), ties), plane, reversed });
        let broken = found.broken.map(|broken| Flaw {
            check: broken.rule(),
            vertices: Vec::new(),
            got: "signs, or loops, broke the rule".to_owned(),
            truth: broken.rule().to_owned(),
        });
        // Loops that touch may cross once they are perturbed: then they bound nothing that has triangles.
        let crosses = perturbed.as_ref().is_some_and(|perturbed| perturbed.crosses(truth));
        if crosses {
            outcome.note(Class::TieBroken, most, || unreachable!("legal"));
            continue;
        }
        let flat = if zero == ZeroMeaning::Never { Flat::Anywhere } else { Flat::WhereLoopsTouch };
        let mut all: Vec<Flaw> = flaws(truth, &found.triangles, flat);
        all.extend(broken);
        if all.is_empty()
            && let Some(perturbed) = &perturbed
        {
            all.extend(perturbed.inverted(case.scene(), &found.triangles, asked.budget.ties));
        }
        if all.is_empty() {
            outcome.note(Class::Agree, most, || unreachable!("legal"));
        }
        for flaw in all {
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

/// A polygon as the tie judge moves it.
struct Perturbed<'a> {
    judged: Judged<'a>,
    plane: Plane,
    reversed: bool,
}

impl Perturbed<'_> {
    fn turn(&self, [a, b, c]: [Vertex; 3]) -> Sign {
        let sign = self.judged.orient2d(self.plane, a, b, c);
        if self.reversed { -sign } else { sign }
    }

    /// Whether two edges that touch cross.
    fn crosses(&self, polygon: &Polygon) -> bool {
        let parts =
            |[a, b]: [Vertex; 2], [c, d]: [Vertex; 2]| self.turn([a, b, c]) * self.turn([a, b, d]) == Sign::Negative;
        polygon.touches().touching.iter().any(|touch| {
            let [e, f] = touch.edges;
            parts(e, f) && parts(f, e)
        })
    }

    /// The first flat triangle that is clockwise, of a sample.
    fn inverted(&self, scene: &Scene, triangles: &[[Vertex; 3]], budget: usize) -> Option<Flaw> {
        let flat = triangles.iter().filter(|triangle| sign(scene, Question::Orient2d(self.plane), *triangle).is_zero());
        let found = flat.take(budget).find(|triangle| self.turn(**triangle) != Sign::Positive)?;
        Some(Flaw {
            check: "perturbed triangles",
            vertices: found.to_vec(),
            got: format!("the triangle {} is clockwise once perturbed", words(found)),
            truth: "counterclockwise".to_owned(),
        })
    }
}
