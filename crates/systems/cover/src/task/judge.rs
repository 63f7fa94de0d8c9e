//! The judgement of covers by the laws, in the exact scene or in the perturbed scene.

use predicament_judge::{Judged, is_within};
use predicament_laws::published;
use predicament_predicates::{Plane, PredicateKind, Predicates, Query, Question, Scene, Vertex, ZeroMeaning};
use predicament_tasks::{AnswerLine, Asked, Case, Class, Finding, Outcome, Stop};

use super::{CoverTask, checks};
use crate::answer::Cover;
use crate::checks::{self as laws, Law, Verdict};
use crate::truth::{Around, Signs};

const PLANES: [Plane; 3] = [Plane::Xy, Plane::Yz, Plane::Zx];

/// Judges the covers of all loops, each beside the covers of the loops before it.
pub(super) fn judge(
    case: &Case<'_, CoverTask>,
    asked: &Asked<'_>,
    covers: &[Cover],
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    let (scene, content) = (case.scene(), case.content);
    let zero = asked.contract(PredicateKind::Orient3d).zero;
    let exact = Judged::exact(scene);
    // A backend that breaks ties answers about the perturbed scene.
    let ties = asked.backend.tie_judge().filter(|_| zero == ZeroMeaning::Never);
    let perturbed = ties.map(|ties| Judged::perturbed(scene, ties));
    let exact = Signs::new(&exact);
    let perturbed = perturbed.as_ref().map(Signs::new);
    let mut surface = Around::default();
    surface.extend(&content.triangles);
    let mut undecided = 0;
    for (at, (around, cover)) in content.loops.iter().zip(covers).enumerate() {
        asked.watch.done(0)?;
        let by = |signs: &Signs<'_>| {
            let areas = case.truth.areas[at].as_ref();
            laws::Asked { signs, surface: &surface, around, areas }.verdict(cover)
        };
        let of_exact = by(&exact);
        let verdict = perturbed.as_ref().map_or_else(|| of_exact.clone(), by);
        let is_wrong = |verdict: &Verdict| matches!(verdict, Verdict::Wrong { .. });
        undecided += usize::from(verdict == Verdict::Undecided);
        let (class, check, what) = match &verdict {
            Verdict::Wrong { triangles, .. } if zero == ZeroMeaning::Band && is_open(asked.session, triangles) => {
                (Class::InBand, "", String::new())
            }
            Verdict::Wrong { law, what, .. } => (Class::Topology, checks::name(*law), what.clone()),
            _ if is_wrong(&of_exact) => (Class::TieBroken, "", String::new()),
            _ => (Class::Agree, "", String::new()),
        };
        if asked.budget.answers {
            let (answer, exact) = (cover.to_string(), what.clone());
            outcome.answers.push(AnswerLine { query: at, args: around.clone(), answer, exact, class, stage: "" });
        }
        outcome.note(class, asked.budget.findings_per_class, || {
            Finding::plain(class, check, vec![Query::of_task("cover", around)], cover.to_string(), what)
        });
        if let Cover::Triangles(triangles) = cover
            && !matches!(verdict, Verdict::Wrong { law: Law::Disk, .. })
        {
            surface.extend(triangles);
        }
    }
    outcome.sampled =
        (undecided > 0).then(|| format!("loops whose covers were not all tried: {undecided} of {}", covers.len()));
    Ok(())
}

/// True if a sign that decides about one of these triangles, or about two of them, is zero within the published band.
fn is_open(session: &dyn Predicates, triangles: &[[Vertex; 3]]) -> bool {
    let scene = session.scene();
    let upper = |question: Question| published::band(session, question).map_or(0.0, |band| band.upper);
    let (volume, areas) = (upper(Question::Orient3d), PLANES.map(|plane| upper(Question::Orient2d(plane))));
    let flat = |corners: &[Vertex; 3]| {
        PLANES.into_iter().zip(areas).all(|(plane, limit)| within(scene, Question::Orient2d(plane), corners, limit))
    };
    let pairs = triangles.iter().enumerate().flat_map(|(at, t)| triangles[at + 1..].iter().map(move |u| [t, u]));
    triangles.iter().any(flat)
        || pairs.into_iter().any(|[t, u]| {
            let mut corners = [*t, *u].concat();
            corners.sort_unstable();
            corners.dedup();
            fours(&corners).into_iter().any(|four| within(scene, Question::Orient3d, &four, volume))
        })
}

fn within(scene: &Scene, question: Question, args: &[Vertex], limit: f64) -> bool {
    limit > 0.0 && is_within(scene, question, args, limit)
}

/// All choices of four of these vertices.
fn fours(all: &[Vertex]) -> Vec<[Vertex; 4]> {
    let mut found = Vec::new();
    for d in 3..all.len() {
        for c in 2..d {
            for b in 1..c {
                found.extend((0..b).map(|a| [a, b, c, d].map(|at| all[at])));
            }
        }
    }
    found
}
