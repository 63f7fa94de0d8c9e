//! Judging of triangles against the truth about their polygon.

use crate::checks::{Flat, Flaw, Polygon, flaws, limit_flaws};
use predicament_judge::{Judged, sign};
use predicament_predicates::{Plane, PredicateKind, Predicates, Query, Question, Scene, Sign, Vertex, ZeroMeaning};

use super::{Triangulate, Triangulated, words};
use predicament_tasks::{Asked, Case, Class, Finding, Outcome, Stop};

/// Judges the triangles of all polygons.
pub(super) fn judge(
    case: &Case<'_, Triangulate>,
    asked: &Asked<'_>,
    answer: &Triangulated,
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    let zero = asked.contract(PredicateKind::Orient2d).zero;
    let most = asked.budget.findings_per_class;
    for (at, (found, examined)) in answer.0.iter().zip(&case.truth.polygons).enumerate() {
        asked.watch.done(0)?;
        if examined.flaw.is_some() {
            continue;
        }
        let (truth, (plane, reversed)) = (&examined.polygon, examined.seen);
        let ties = (zero == ZeroMeaning::Never).then(|| asked.backend.tie_judge()).flatten();
        let perturbed = ties.map(|ties| Perturbed { judged: Judged::perturbed(case.scene(), ties), plane, reversed });
        let broken = found.broken.map(|broken| Flaw {
            check: broken.rule(),
            vertices: Vec::new(),
            got: "the signs or the loops broke the rule".to_owned(),
            truth: broken.rule().to_owned(),
        });
        // Loops that touch may cross once they are perturbed. Then the perturbed polygon has no triangulation, and the
        // triangles are judged in the limit.
        let crosses = perturbed.as_ref().is_some_and(|perturbed| perturbed.crosses(truth));
        let all = if crosses {
            limit_flaws(truth, &found.triangles)
        } else {
            let flat = if zero == ZeroMeaning::Never { Flat::Anywhere } else { Flat::WhereLoopsTouch };
            let mut all: Vec<Flaw> = flaws(truth, &found.triangles, flat);
            all.extend(broken);
            if all.is_empty()
                && let Some(perturbed) = &perturbed
            {
                all.extend(perturbed.inverted(case.scene(), &found.triangles, asked.budget.ties));
            }
            all
        };
        if all.is_empty() {
            let class = if crosses { Class::TieBroken } else { Class::Agree };
            outcome.note(class, most, || unreachable!("legal"));
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

/// A polygon as the tie judge perturbs it.
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

    /// True if two edges that touch cross in the perturbed scene.
    fn crosses(&self, polygon: &Polygon) -> bool {
        let parts =
            |[a, b]: [Vertex; 2], [c, d]: [Vertex; 2]| self.turn([a, b, c]) * self.turn([a, b, d]) == Sign::Negative;
        polygon.touches().touching.iter().any(|touch| {
            let [e, f] = touch.edges;
            parts(e, f) && parts(f, e)
        })
    }

    /// The first flat triangle that is clockwise in the perturbed scene, in a sample.
    fn inverted(&self, scene: &Scene, triangles: &[[Vertex; 3]], budget: usize) -> Option<Flaw> {
        let flat = triangles.iter().filter(|triangle| sign(scene, Question::Orient2d(self.plane), *triangle).is_zero());
        let found = flat.take(budget).find(|triangle| self.turn(**triangle) != Sign::Positive)?;
        Some(Flaw {
            check: "perturbed triangles",
            vertices: found.to_vec(),
            got: format!("the triangle {} is clockwise in the perturbed scene", words(found)),
            truth: "counterclockwise".to_owned(),
        })
    }
}
