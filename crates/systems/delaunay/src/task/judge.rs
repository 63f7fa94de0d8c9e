//! The judgement of a triangulation by the checks.

use crate::algorithm::{Delaunay2, delaunay2d, delaunay2d_in_order};
use crate::checks::{Cut, Found, flaws};
use crate::truth::PAIRS;
use predicament_hull::checks::{Flaw, Signs};
use predicament_judge::Judged;
use predicament_predicates::{PredicateKind, Predicates, Query, Scene, Vertex, ZeroMeaning};

use super::Delaunay2d;
use predicament_tasks::{Asked, Case, Class, Finding, Outcome};

/// The maximum number of points of which half are removed and inserted again.
const MOVED: usize = 500;

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
    let contract = asked.contract(PredicateKind::Incircle);
    let points = case.content.points;
    // Proved signs are exact signs, or those of one perturbed scene.
    if contract.proved && contract.zero != ZeroMeaning::Band && case.content.constraints.is_empty() && points <= MOVED {
        flaws.extend(trace_of_removals(asked.session, found));
    }
    flaws.iter().for_each(|flaw| note(outcome, flaw));
    if flaws.is_empty() {
        outcome.counts.add(Class::Agree, outcome.queries);
    }
}

/// The difference, if every second vertex is removed and inserted again.
fn trace_of_removals(session: &dyn Predicates, found: &Delaunay2) -> Option<Flaw> {
    let (moved, kept): (Vec<Vertex>, Vec<Vertex>) = session.scene().vertices().partition(|v| v.index() % 2 == 0);
    let flaw = |what: String| Some(Flaw { check: "removal", places: 1, vertices: Vec::new(), what });
    let mut triangulation = delaunay2d(session);
    if let Some((v, broken)) = moved.iter().find_map(|&v| triangulation.remove(session, v).err().map(|why| (v, why))) {
        return flaw(format!("removing {v}: {broken}"));
    }
    triangulation.cut_faces();
    if triangulation.answer() != delaunay2d_in_order(session, &kept).answer() {
        return flaw("a vertex that was removed has left a trace".to_owned());
    }
    if let Some((v, broken)) = moved.iter().find_map(|&v| triangulation.insert(session, v).err().map(|why| (v, why))) {
        return flaw(format!("inserting {v} again: {broken}"));
    }
    triangulation.cut_faces();
    if triangulation.answer() == *found {
        None
    } else {
        flaw("inserted again, vertices have other triangles".to_owned())
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
