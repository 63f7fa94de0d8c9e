//! Hulls against what a convex hull is, and small ones against the definition.

use crate::algorithm::Contradiction;
use crate::checks::{Flaw, Signs};
use predicament_judge::{Judged, hull as definition};
use predicament_predicates::{PredicateKind, Predicates, Query, Scene, Vertex, ZeroMeaning};

use predicament_tasks::{Asked, Case, Class, Finding, Outcome, Task};

/// The most points of a scene whose perturbed hull is found by definition: each sign may be a tie.
const FEW: usize = 9;
/// Pairs of a point and a face that are judged, at level quick and at level full.
const PAIRS: [usize; 2] = [20_000, 1 << 18];

/// What is true about a hull.
pub struct Truth {
    /// Its vertices, by definition, where there are few points.
    extreme: Option<Vec<Vertex>>,
    points: usize,
}

impl Truth {
    /// By definition.
    pub(super) fn new(scene: &Scene) -> Truth {
        let is_small = scene.len() <= definition::most(scene.dimension());
        let extreme = is_small.then(|| definition::extreme(&Judged::exact(scene)));
        Truth { extreme, points: scene.len() }
    }

    /// In a few words.
    pub(super) fn described(&self) -> String {
        match &self.extreme {
            Some(extreme) => format!("{} of them extreme", extreme.len()),
            None => "too many to count the extreme ones by definition".to_owned(),
        }
    }

    /// What is judged, where it is not all.
    pub(super) fn sampled(&self) -> Option<String> {
        let [most, _] = PAIRS;
        (self.extreme.is_none() && 2 * self.points > most)
            .then(|| "convex at every edge and wound once; points inside: an even sample".to_owned())
    }
}

/// What a backend's answer is held against.
pub(super) struct Found<'a> {
    /// The vertices.
    pub vertices: &'a [Vertex],
    /// The invariant that the algorithm found broken.
    pub broken: Option<Contradiction>,
    /// What is wrong with it, by these signs.
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
    flaws.extend(by_definition(scene, &case.truth, signs, found.vertices));
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

/// `extreme vertices`: those of the definition. Where ties are broken there may be more: all of them by the perturbed
/// signs where there are very few points, else one at least in each place of the definition's.
fn by_definition(scene: &Scene, truth: &Truth, signs: Signs<'_>, vertices: &[Vertex]) -> Option<Flaw> {
    const CHECK: &str = "extreme vertices";
    let mut found = vertices.to_vec();
    found.sort_unstable();
    let wanted = match signs.perturbed {
        Some(perturbed) if scene.len() <= FEW => definition::extreme(perturbed),
        Some(_) => {
            let is_there = |v: Vertex| found.iter().any(|&w| scene.has(w) && scene.point(v) == scene.point(w));
            let missing = truth.extreme.as_ref()?.iter().copied().find(|&v| !is_there(v))?;
            let what = format!("no vertex in the place of {missing}, which is extreme");
            return Some(Flaw { check: CHECK, places: 1, vertices: vec![missing], what });
        }
        None => truth.extreme.clone()?,
    };
    let differ = |from: &[Vertex], others: &[Vertex]| from.iter().copied().find(|v| !others.contains(v));
    let (vertex, what) = match (differ(&wanted, &found), differ(&found, &wanted)) {
        (Some(missing), _) => (missing, format!("{missing} is extreme by definition and no vertex")),
        (_, Some(other)) => (other, format!("{other} is a vertex and not extreme by definition")),
        _ => return None,
    };
    Some(Flaw { check: CHECK, places: 1, vertices: vec![vertex], what })
}
