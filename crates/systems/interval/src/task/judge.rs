//! The judgement of an answer: probes by the rule without infinitesimals, and cells by their consistency.

use crate::algorithm::place;
use crate::answer::{Found, Place};
use crate::checks::partition_fault;
use crate::truth::perturbed;
use predicament_predicates::{PredicateKind, Predicates, Query, Vertex, ZeroMeaning};

use super::{Cells, Interval, describe};
use predicament_tasks::{AnswerLine, Asked, Case, Class, Finding, Outcome, Stop};

/// The place of the probe relative to the union of all cells.
fn whole(session: &dyn Predicates, content: &Cells, probe: Vertex) -> Place {
    match (content.cells.first(), content.cells.last()) {
        (Some(&[left, _]), Some(&[_, right])) => place(session, content.axis, [left, right], probe),
        _ => Place::Outside,
    }
}

/// Judges the cells of all probes.
pub(super) fn judge(
    case: &Case<'_, Interval>,
    asked: &Asked<'_>,
    found: &[Found],
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    let zero = asked.contract(PredicateKind::Compare).zero;
    let perturbed = |probe| perturbed(case.scene(), case.content, probe);
    for (at, (cells, &probe)) in found.iter().zip(&case.content.probes).enumerate() {
        let exact = &case.truth[at];
        let whole = whole(asked.session, case.content, probe);
        let (class, check) = class(zero, whole, cells, exact, || perturbed(probe));
        if asked.budget.answers {
            outcome.answers.push(AnswerLine {
                query: at,
                args: vec![probe],
                answer: describe(cells),
                exact: describe(exact),
                class,
                stage: "",
            });
        }
        outcome.note(class, asked.budget.findings_per_class, || {
            let truth = match zero {
                ZeroMeaning::Never => perturbed(probe),
                ZeroMeaning::Exact | ZeroMeaning::Band => exact.clone(),
            };
            let query = Query::of_task("interval", &[probe]);
            Finding::plain(class, check, vec![query], describe(cells), describe(&truth))
        });
    }
    Ok(())
}

/// The class of an answer and the check that gives it.
fn class(
    zero: ZeroMeaning,
    whole: Place,
    found: &Found,
    exact: &Found,
    perturbed: impl FnOnce() -> Found,
) -> (Class, &'static str) {
    if let Some(fault) = partition_fault(whole, found.iter().map(|&(_, place)| place)) {
        return (Class::Topology, fault.name());
    }
    let at_end = |cells: &Found| cells.iter().any(|&(_, place)| place == Place::AtEnd);
    match zero {
        ZeroMeaning::Never if at_end(found) => (Class::Inconsistent, "never zero"),
        ZeroMeaning::Never if *found != perturbed() => (Class::SignFlip, "half-open rule"),
        ZeroMeaning::Never if at_end(exact) => (Class::TieBroken, "cells"),
        ZeroMeaning::Never => (Class::Agree, "cells"),
        ZeroMeaning::Exact | ZeroMeaning::Band => {
            let lost = |from: &Found, to: &Found| {
                from.iter().any(|&(cell, place)| place == Place::AtEnd && !to.contains(&(cell, Place::AtEnd)))
            };
            let class = match (found == exact, lost(exact, found), lost(found, exact)) {
                (true, _, _) => Class::Agree,
                (false, true, _) => Class::MissedZero,
                (false, false, true) => Class::Overreach,
                (false, false, false) => Class::SignFlip,
            };
            (class, "cells")
        }
    }
}
