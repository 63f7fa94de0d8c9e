//! The exact answer, by comparing rationals, and the classification of each vertex of an answer.

use predicament::judge::{Judged, rational};
use predicament::predicates::{Axis, PredicateKind, Predicates, Query, Scene, Sign, Vertex, ZeroMeaning};
use predicament::tasks::{Asked, Case, Class, Finding, Outcome, Stop, Watch};

use crate::{Among, Leftmost, LeftmostRow};

/// The vertices with the smallest x: the truth, which asks no backend and no algorithm.
pub fn exactly(scene: &Scene, content: &Among) -> Vec<Vertex> {
    let x = |vertex: Vertex| rational(scene.coordinate(Axis::X, vertex));
    let smallest = content.0.iter().map(|&vertex| x(vertex)).min();
    content.0.iter().copied().filter(|&vertex| Some(x(vertex)) == smallest).collect()
}

/// The exact answer for [`Task::truth`](predicament::tasks::Task::truth).
pub fn truth(scene: &Scene, content: &Among, watch: &Watch) -> Result<Vec<Vertex>, Stop> {
    watch.done(0)?;
    let leftmost = exactly(scene, content);
    watch.done(content.0.len() as u64)?;
    Ok(leftmost)
}

/// The right answer for a backend that breaks ties: the leftmost vertex of the truth, by its tie judge.
fn perturbed(case: &Case<'_, Leftmost>, asked: &Asked<'_>) -> Vec<Vertex> {
    let Some(ties) = asked.backend.tie_judge() else { return case.truth.clone() };
    let session = Judged::perturbed(case.scene(), ties);
    let is_left = |&a: &Vertex| case.truth.iter().all(|&b| a == b || session.compare(Axis::X, a, b) == Sign::Negative);
    case.truth.iter().copied().filter(is_left).collect()
}

/// Classifies every vertex: is it one of the leftmost, and should it be?
pub fn judge(case: &Case<'_, Leftmost>, asked: &Asked<'_>, found: &[Vertex], outcome: &mut Outcome) {
    let zero = asked.contract(PredicateKind::Compare).zero;
    let (wanted, breaks_ties) = match zero {
        ZeroMeaning::Never => (perturbed(case, asked), true),
        ZeroMeaning::Exact | ZeroMeaning::Band => (case.truth.clone(), false),
    };
    // If a right vertex was found, other errors are wrong zeros; if none was found, they are wrong signs.
    let is_zero = !breaks_ties && found.iter().any(|vertex| wanted.contains(vertex));
    for vertex in &case.content.0 {
        let (is, should) = (found.contains(vertex), wanted.contains(vertex));
        let class = match (is, should) {
            _ if breaks_ties && is && found.len() > 1 => Class::Inconsistent,
            (true, false) if is_zero => Class::Overreach,
            (false, true) if is_zero => Class::MissedZero,
            (true, false) | (false, true) => Class::SignFlip,
            _ if breaks_ties && case.truth.len() > 1 && case.truth.contains(vertex) => Class::TieBroken,
            _ => Class::Agree,
        };
        outcome.note(class, asked.budget.findings_per_class, || {
            let query = Query::of_task("leftmost", &[*vertex]);
            Finding::plain(class, "smallest x", vec![query], says(is).to_owned(), says(should).to_owned())
        });
    }
    outcome.row(&LeftmostRow::of(case, asked, found));
}

/// An answer about one vertex, in words.
pub fn says(leftmost: bool) -> &'static str {
    if leftmost { "leftmost" } else { "not leftmost" }
}
