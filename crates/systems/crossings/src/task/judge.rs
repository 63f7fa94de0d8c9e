//! The judgement of the crossings along each segment by the truth.

use std::collections::BTreeSet;

use crate::truth::{self, Along};
use predicament_predicates::{PredicateKind, Query, Scene, ZeroMeaning};

use super::{Crossings, Segments, describe};
use predicament_tasks::{Asked, Case, Class, Finding, Outcome, Stop};

/// Judges the crossings of all segments.
pub(super) fn judge(
    case: &Case<'_, Crossings>,
    asked: &Asked<'_>,
    found: &[Along],
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    let (scene, content) = (case.scene(), case.content);
    let zero = asked.contract(PredicateKind::Orient2d).zero;
    // A backend that breaks ties has to find the crossings of the perturbed scene.
    let perturbed = match (zero, asked.backend.tie_judge()) {
        (ZeroMeaning::Never, Some(ties)) => truth::perturbed(scene, ties, &content.0, asked.watch)?,
        _ => None,
    };
    for (at, (got, truth)) in found.iter().zip(&case.truth).enumerate() {
        asked.watch.done(0)?;
        let perturbed = perturbed.as_ref().map(|all| &all[at]);
        let (class, check) = class(scene, content, at, zero, got, truth, perturbed);
        outcome.note(class, asked.budget.findings_per_class, || {
            let truth = perturbed.unwrap_or(truth);
            let query = Query::of_task("crossings", &content.0[at]);
            Finding::plain(class, check, vec![query], describe(got), describe(truth))
        });
    }
    Ok(())
}

/// The class of the crossings of one segment, and the check that gives it.
fn class(
    scene: &Scene,
    content: &Segments,
    at: usize,
    zero: ZeroMeaning,
    got: &Along,
    truth: &Along,
    perturbed: Option<&Along>,
) -> (Class, &'static str) {
    match (zero, perturbed) {
        (ZeroMeaning::Never, Some(perturbed)) if got != perturbed => return (Class::SignFlip, "perturbed crossings"),
        (ZeroMeaning::Never, _) if got != truth => return (Class::TieBroken, "crossings"),
        _ if got == truth => return (Class::Agree, "crossings"),
        _ => {}
    }
    let set = |along: &Along| -> BTreeSet<u32> { along.iter().flatten().copied().collect() };
    let (has, wanted) = (set(got), set(truth));
    if let Some(&other) = has.symmetric_difference(&wanted).next() {
        let touch = truth::touches(scene, content.0[at], content.0[other as usize]);
        return match (touch, has.contains(&other)) {
            (true, true) => (Class::MissedZero, "crossings"),
            _ => (Class::SignFlip, "crossings"),
        };
    }
    // The same crossings in another order, or grouped differently.
    let flat = |along: &Along| along.iter().flatten().copied().collect::<Vec<u32>>();
    match (got.len() > truth.len(), got.len() < truth.len()) {
        (true, _) => (Class::MissedZero, "order"),
        (_, true) => (Class::Overreach, "order"),
        _ if flat(got) == flat(truth) => (Class::MissedZero, "order"),
        _ => (Class::SignFlip, "order"),
    }
}
