//! The judgement of the nearest pairs by the truth.

use crate::answer::{Kind, Nearest, Pair, describe};
use crate::truth::{Truth, measured, root};
use predicament_predicates::{PredicateKind, Query, Scene, Vertex, ZeroMeaning};
use predicament_tasks::{Asked, Case, Class, Finding, Outcome, Stop};

use super::Distance;
use super::bands::Bands;
use super::checks::{KIND, NEAREST, TIES};

/// Judges an answer.
pub(super) fn judge(
    case: &Case<'_, Distance>,
    asked: &Asked<'_>,
    got: &Nearest,
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    asked.watch.done(0)?;
    let (scene, truth) = (case.scene(), &case.truth);
    let has_bands = asked.contract(PredicateKind::Orient2d).zero == ZeroMeaning::Band;
    let (mut class, check) = class(scene, got, truth);
    if !class.is_legal() && has_bands && Bands::new(asked.session).allow(got, truth) {
        class = Class::InBand;
    }
    outcome.note(class, asked.budget.findings_per_class, || {
        let pair = got.pairs.first().or(truth.pairs.first());
        let args: Vec<Vec<Vertex>> = pair.into_iter().flatten().map(|feature| feature.corners().to_vec()).collect();
        let query = Query { what: "distance".to_owned(), detail: None, args };
        let wanted: Vec<Pair> = truth.pairs.iter().copied().collect();
        let exact = format!("{}, at about {:e}", told(truth.kind, &wanted), root(&truth.squared));
        Finding::plain(class, check, vec![query], told(got.kind, &got.pairs), exact)
    });
    Ok(())
}

/// An answer in words; of many pairs the first few.
pub(super) fn told(kind: Kind, pairs: &[Pair]) -> String {
    const SHOWN: usize = 4;
    let more = pairs.len().saturating_sub(SHOWN);
    let shown = describe(&pairs[..pairs.len() - more]);
    match (pairs.is_empty(), more) {
        (true, _) => kind.name().to_owned(),
        (_, 0) => format!("{}: {shown}", kind.name()),
        _ => format!("{}: {shown}, and {more} more", kind.name()),
    }
}

/// The class of an answer, without bands, and the check that gives it.
fn class(scene: &Scene, got: &Nearest, truth: &Truth) -> (Class, &'static str) {
    match (got.kind.is_zero(), truth.kind.is_zero()) {
        (false, true) => return (Class::MissedZero, KIND),
        (true, false) => return (Class::Overreach, KIND),
        _ if got.kind != truth.kind => return (Class::SignFlip, KIND),
        _ => {}
    }
    let extra: Vec<&Pair> = got.pairs.iter().filter(|pair| !truth.pairs.contains(*pair)).collect();
    let found = got.pairs.len() - extra.len();
    // A pair that is no pair, or is nearer than the truth, is an error whatever else was found.
    let is_wrong = |pair: &&&Pair| measured(scene, pair).is_none();
    if extra.iter().any(|pair| is_wrong(&pair)) || found == 0 && !truth.pairs.is_empty() {
        return (Class::SignFlip, NEAREST);
    }
    if !extra.is_empty() {
        return (Class::Overreach, TIES);
    }
    if found < truth.pairs.len() {
        return (Class::MissedZero, TIES);
    }
    (Class::Agree, NEAREST)
}
