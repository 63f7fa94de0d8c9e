//! The judgement of the hits of each query by the truth.

use std::collections::BTreeSet;

use crate::answer::{Feature, Groups, Hit, Hits, describe};
use crate::truth::{Known, Perturbed, Ties};
use predicament_predicates::{Construction, PredicateKind, Query, ZeroMeaning};

use super::bands::Bands;
use super::checks::{HITS, ORDER, PARITY, PERTURBED};
use super::{MeshRays, RayScene};
use predicament_tasks::{AnswerLine, Asked, Case, Class, Finding, Outcome, Stop};

/// Judges the hits of all queries of the sample.
pub(super) fn judge(
    case: &Case<'_, MeshRays>,
    asked: &Asked<'_>,
    found: &[Hits],
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    let (scene, content) = (case.scene(), case.content);
    let zero = asked.contract(PredicateKind::Orient3d).zero;
    let bands = Bands::new(asked.session, content);
    // A backend that breaks ties has to find the hits of the perturbed scene.
    let ties = match (zero, asked.backend.tie_judge()) {
        (ZeroMeaning::Never, Some(judge)) => {
            let (triangles, extent, constructs) = (&content.triangles[..], content.extent, constructs(case, asked));
            Some(Ties { scene, judge, triangles, extent, constructs })
        }
        _ => None,
    };
    for (at, got) in found.iter().enumerate() {
        asked.watch.done(0)?;
        let Some(known) = case.truth.of(at) else { continue };
        let ends = content.rays[at];
        let wanted = ties.as_ref().map(|ties| ties.hits(ends, known));
        let (class, check) = class(&bands, content, at, zero, got, known, wanted.as_ref());
        let told = |crossings: Option<i64>| crossings.map_or_else(|| "not defined".to_owned(), |n| n.to_string());
        let [answer, exact] = if check == PARITY {
            [told(got.crossings), told(known.crossings)]
        } else {
            let exact = wanted.as_ref().and_then(Perturbed::groups).unwrap_or(&known.groups);
            [describe(&got.groups), describe(exact)]
        };
        if asked.budget.answers {
            let (answer, exact, args) = (answer.clone(), exact.clone(), ends.to_vec());
            outcome.answers.push(AnswerLine { query: at, args, answer, exact, class, stage: "" });
        }
        outcome.note(class, asked.budget.findings_per_class, || {
            Finding::plain(class, check, vec![Query::of_task("mesh-rays", &ends)], answer, exact)
        });
    }
    Ok(())
}

/// True if the backend constructs the point of some hit: a scheme of perturbation may not.
fn constructs(case: &Case<'_, MeshRays>, asked: &Asked<'_>) -> bool {
    let content = case.content;
    let hit = (0..content.rays.len()).find_map(|at| {
        let crossed = case.truth.of(at)?.groups.iter().flatten().find(|hit| !hit.is_along);
        let Some(Hit { feature: Feature::Face(face), .. }) = crossed else { return None };
        Some(Construction::Lpi { line: content.rays[at], plane: content.triangles[*face as usize] })
    });
    let mut constructs = false;
    let asked = asked.backend.with_session(case.scene(), &mut |session| {
        constructs = hit.is_some_and(|hit| session.construct(&[hit]).is_ok());
    });
    asked.is_ok() && constructs
}

/// The class of the hits of one query, and the check that gives it.
fn class(
    bands: &Bands<'_>,
    content: &RayScene,
    at: usize,
    zero: ZeroMeaning,
    got: &Hits,
    known: &Known,
    wanted: Option<&Perturbed>,
) -> (Class, &'static str) {
    let (class, check) = match wanted {
        Some(wanted) if !wanted.is(&got.groups, known) => {
            let is_face = |hit: &Hit| matches!(hit.feature, Feature::Face(_)) && !hit.is_along;
            return match got.groups.iter().flatten().all(is_face) {
                true => (Class::SignFlip, PERTURBED),
                false => (Class::Inconsistent, PERTURBED),
            };
        }
        Some(_) if got.groups != known.groups => (Class::TieBroken, HITS),
        _ if got.groups == known.groups => (Class::Agree, HITS),
        _ => different(bands, content, at, zero, &got.groups, &known.groups),
    };
    let is_open = zero == ZeroMeaning::Band && (class == Class::InBand || got.crossings.is_none());
    match (got.crossings, known.crossings) {
        (Some(sum), Some(truth)) if class.is_legal() && sum != truth && !is_open => (Class::Topology, PARITY),
        (None, Some(_)) if class.is_legal() && !is_open => (Class::Topology, PARITY),
        _ => (class, check),
    }
}

/// The class of hits that differ from the truth.
fn different(
    bands: &Bands<'_>,
    content: &RayScene,
    at: usize,
    zero: ZeroMeaning,
    got: &Groups,
    truth: &Groups,
) -> (Class, &'static str) {
    let set = |groups: &Groups| -> BTreeSet<Hit> { groups.iter().flatten().copied().collect() };
    let (has, wanted) = (set(got), set(truth));
    let strange: Vec<&Hit> = has.symmetric_difference(&wanted).collect();
    if strange.is_empty() {
        return order(bands, zero, got, truth);
    }
    if zero == ZeroMeaning::Band && strange.iter().all(|hit| bands.allow(content.rays[at], hit.feature)) {
        return (Class::InBand, HITS);
    }
    // Features that need a zero: lost ones are missed zeros, added ones are wrong zeros.
    let is_degenerate = |hit: &&Hit| hit.is_along || !matches!(hit.feature, Feature::Face(_));
    let class = if wanted.difference(&has).any(|hit| is_degenerate(&hit)) {
        Class::MissedZero
    } else if has.difference(&wanted).any(|hit| is_degenerate(&hit)) {
        Class::Overreach
    } else {
        Class::SignFlip
    };
    (class, HITS)
}

/// The class of the same hits in another order, or grouped differently.
fn order(bands: &Bands<'_>, zero: ZeroMeaning, got: &Groups, truth: &Groups) -> (Class, &'static str) {
    let flat = |groups: &Groups| groups.iter().flatten().copied().collect::<Vec<Hit>>();
    let all = flat(truth);
    let is_close = |one: &Hit| all.iter().any(|other| other != one && bands.leave_open(one.feature, other.feature));
    if zero == ZeroMeaning::Band && all.iter().any(is_close) {
        return (Class::InBand, ORDER);
    }
    let class = match (got.len() > truth.len(), got.len() < truth.len()) {
        (true, _) => Class::MissedZero,
        (_, true) => Class::Overreach,
        _ if flat(got) == all => Class::MissedZero,
        _ => Class::SignFlip,
    };
    (class, ORDER)
}
