//! The judgement of a triangulation by the checks.

use crate::algorithm::Delaunay2;
use crate::checks::{Cut, Found, flaws};
use crate::truth::PAIRS;
use predicament_hull::checks::{Flaw, Signs};
use predicament_judge::Judged;
use predicament_predicates::{PredicateKind, Predicates, Query, Scene, Vertex, ZeroMeaning};

use super::Delaunay2d;
use predicament_tasks::{Asked, Case, Class, Finding, Outcome};

/// Judges a triangulation.
pub(super) fn judge(case: &Case<'_, Delaunay2d>, asked: &Asked<'_>, found: &Delaunay2, outcome: &mut Outcome) {
    // The scene with the exact crossing points of constraints.
    let mut scene = case.scene().clone();
    for definition in &found.crossings {
        if scene.construct(*definition).is_err() || point_is_missing(&scene) {
            return note(
                outcome,
                &Flaw {
                    check: "crossing",
                    places: 1,
                    vertices: definition.flats().flatten().copied().collect(),
                    what: format!("{definition} is not a point"),
                },
            );
        }
    }
    let scene = &scene;
    let exact = Judged::exact(scene);
    let breaks_ties = asked.contract(PredicateKind::Incircle).zero == ZeroMeaning::Never;
    let ties = asked.backend.tie_judge().filter(|_| breaks_ties);
    let perturbed = ties.map(|ties| Judged::perturbed(scene, ties));
    let signs = Signs {
        exact: &exact,
        perturbed: perturbed.as_ref().map(|judged| judged as &dyn Predicates),
        ties: asked.budget.ties,
        pairs: PAIRS[usize::from(asked.budget.thorough)],
    };
    let mut flaws = flaws(
        signs,
        Found {
            triangles: &found.triangles,
            chain: &found.chain,
            copies: &found.copies,
            constraints: &case.content.constraints,
            cut: Cut::Fan,
        },
    );
    if let Some(broken) = found.broken {
        let what = "the algorithm stopped there".to_owned();
        flaws.insert(0, Flaw { check: broken.rule(), places: 1, vertices: Vec::new(), what });
    }
    flaws.iter().for_each(|flaw| note(outcome, flaw));
    if flaws.is_empty() {
        outcome.counts.add(Class::Agree, outcome.queries);
    }
}

/// True if the last constructed vertex has no point.
fn point_is_missing(scene: &Scene) -> bool {
    let last = scene.constructions().len().checked_sub(1).map(Vertex::constructed);
    last.is_some_and(|v| predicament_judge::point(scene, v).is_none())
}

/// Adds a flaw to the findings.
pub(super) fn note(outcome: &mut Outcome, flaw: &Flaw) {
    outcome.counts.add(Class::Topology, 1);
    let is_query = !flaw.vertices.is_empty() && flaw.vertices.len() <= 4;
    let queries = if is_query { vec![Query::of_task("delaunay2d", &flaw.vertices)] } else { Vec::new() };
    let more = if flaw.places > 1 { format!("; {} places", flaw.places) } else { String::new() };
    let got = format!("{}{more}", flaw.what);
    outcome.findings.push(Finding::plain(
        Class::Topology,
        flaw.check,
        queries,
        got,
        "a Delaunay triangulation".to_owned(),
    ));
}
