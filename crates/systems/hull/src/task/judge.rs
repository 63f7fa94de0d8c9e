//! The judgement of hulls by the checks, and of small ones by the definition.

use crate::algorithm::Contradiction;
use crate::checks::{Flaw, Signs};
use crate::truth::{PAIRS, Truth};
use predicament_judge::Judged;
use predicament_predicates::{PredicateKind, Predicates, Query, Vertex, ZeroMeaning};

use predicament_tasks::{Asked, Case, Class, Finding, Outcome, Task};

/// A backend's answer, and its checks.
pub(super) struct Found<'a> {
    /// The vertices.
    pub vertices: &'a [Vertex],
    /// The invariant that the algorithm found broken.
    pub broken: Option<Contradiction>,
    /// The failed checks of the answer, by these signs.
    pub flaws: &'a dyn Fn(Signs<'_>) -> Vec<Flaw>,
}

/// Judges a hull.
pub(super) fn judge<T: Task<Truth = Truth>>(
    task: &'static str,
    case: &Case<'_, T>,
    asked: &Asked<'_>,
    found: &Found<'_>,
    outcome: &mut Outcome,
) {
    let scene = case.scene();
    let exact = Judged::exact(scene);
    let breaks_ties = asked.contract(PredicateKind::Orient2d).zero == ZeroMeaning::Never;
    let ties = asked.backend.tie_judge().filter(|_| breaks_ties);
    let perturbed = ties.map(|ties| Judged::perturbed(scene, ties));
    let signs = Signs {
        exact: &exact,
        perturbed: perturbed.as_ref().map(|judged| judged as &dyn Predicates),
        ties: asked.budget.ties,
        pairs: PAIRS[usize::from(asked.budget.thorough)],
    };
    let mut flaws = (found.flaws)(signs);
    if let Some(broken) = found.broken {
        let what = "the algorithm stopped there".to_owned();
        flaws.insert(0, Flaw { check: broken.rule(), places: 1, vertices: Vec::new(), what });
    }
    flaws.extend(case.truth.not_extreme(scene, signs, found.vertices));
    for flaw in &flaws {
        outcome.counts.add(Class::Topology, 1);
        let queries = if flaw.vertices.is_empty() { Vec::new() } else { vec![Query::of_task(task, &flaw.vertices)] };
        let more = if flaw.places > 1 { format!("; {} places", flaw.places) } else { String::new() };
        let got = format!("{}{more}", flaw.what);
        outcome.findings.push(Finding::plain(Class::Topology, flaw.check, queries, got, "a convex hull".to_owned()));
    }
    if flaws.is_empty() {
        outcome.counts.add(Class::Agree, outcome.queries);
    }
}
