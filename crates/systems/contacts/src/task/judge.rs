//! The judgement of every registered pair of two complexes by the truth.
//!
//! The truth is computed by linear equations in rationals, for all pairs whose boxes meet; if these are too many, for
//! every n-th simplex of the first complex. A pair that a backend registers is always judged: the sample limits only
//! the search for missed pairs. The judged pairs are those that the truth or the backend registers. A pair that neither
//! registers does not count as an answer, as there are too many. For backends that break ties, the truth also has the
//! crossings in the perturbed scene.
//!
//! The registration of a pair depends only on its faces. So one pair can be queried again separately, and some pairs of
//! the truth are computed twice, the second time by the hierarchy on the judge's signs.

use std::collections::{BTreeMap, BTreeSet};

use crate::answer::{Contacts as Registered, Weights};
use crate::truth::{Pair, Truth, perturbed};
use predicament_judge::{Judged, contacts as judge};
use predicament_predicates::{PredicateKind, Scene, ZeroMeaning};

use super::classes::{self, Judgement};
use super::pairs::Pairs;
use super::section::ContactRow;
use super::{Complexes, Contacts, band, order, query, topology, vertices_of};
use predicament_tasks::{Agreement, Asked, Case, Class, Finding, Outcome, Stop};

/// The maximum number of orders of a pair's vertices: the cost of a pair in the budget for permutations.
const ORDERS: usize = 24;

/// The pairs that were registered.
fn pairs<'p>(truth: &'p Truth, content: &'p Complexes, contacts: &Registered) -> Pairs<'p> {
    let pairs = contacts.registered.iter().map(|contact| [contact.a, contact.b]);
    Pairs::new(content.both(), &truth.faces, pairs.collect())
}

/// The truth, extended by these pairs and their faces.
fn about<'p>(truth: &'p Truth, scene: &Scene, content: &'p Complexes, pairs: impl Iterator<Item = Pair>) -> Pairs<'p> {
    let mut registered = truth.registered.clone();
    let [of_a, of_b] = &truth.faces;
    let faces = pairs.flat_map(|[s, t]| of_a.of(s).flat_map(move |s| of_b.of(t).map(move |t| [s, t])));
    let unknown: BTreeSet<Pair> = faces.filter(|[s, _]| !truth.sampled.contains(s)).collect();
    registered.extend(unknown.into_iter().filter(|&pair| {
        let [s, t] = vertices_of(content, pair);
        judge::contact(scene, s, t).is_some()
    }));
    Pairs::new(content.both(), &truth.faces, registered)
}

/// Judges all pairs that the backend registers.
pub(super) fn judge(
    case: &Case<'_, Contacts>,
    asked: &Asked<'_>,
    found: &Registered,
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    let (scene, content, session, watch) = (case.scene(), case.content, asked.session, asked.watch);
    let dimension = scene.dimension();
    let zero = asked.contract(PredicateKind::Orient2d).zero;
    let got = pairs(&case.truth, content, found);
    let perturbed = match (zero, asked.backend.tie_judge()) {
        (ZeroMeaning::Never, Some(ties)) => {
            let registered = perturbed(scene, ties, content, &case.truth.sampled, got.iter(), watch)?;
            Some(Pairs::new(content.both(), &case.truth.faces, registered))
        }
        _ => None,
    };
    let audited = match zero {
        ZeroMeaning::Band => band::broken(session, content.both(), found, &got),
        ZeroMeaning::Exact | ZeroMeaning::Never => BTreeMap::new(),
    };
    watch.done(0)?;
    let perturbed = perturbed.as_ref();
    let said = got.iter().chain(perturbed.into_iter().flat_map(Pairs::iter)).chain(audited.keys().copied());
    let truth = about(&case.truth, scene, content, said);
    let judge = classes::Judge { dimension, zero, got: &got, truth: &truth, perturbed, audited: &audited };
    let weights: BTreeMap<Pair, [Weights; 2]> =
        found.registered.iter().map(|contact| ([contact.a, contact.b], [contact.on_a, contact.on_b])).collect();
    let pairs = judge.pairs();
    let orders = asked.budget.permutations / ORDERS;
    let step = pairs.len().div_ceil(orders.max(1)).max(1);
    for (at, &pair) in pairs.iter().enumerate() {
        let mut judgement = judge.class(pair);
        let mut words = [got.say(pair), perturbed.unwrap_or(&truth).say(pair)];
        if judgement.class == Class::Agree && weights.get(&pair).is_some_and(has_nan) {
            judgement = Judgement { class: Class::Nan, check: "weights" };
        }
        // A band's limits are not sharp: another order of the arguments may round to the other side.
        let ask = orders > 0 && zero != ZeroMeaning::Band && at.is_multiple_of(step) && got.ended_by(pair).is_none();
        if judgement.class.is_legal() && ask {
            let [s, t] = vertices_of(content, pair);
            if let Some(contradiction) = order::contradiction(session, s, t) {
                judgement = Judgement { class: Class::Inconsistent, check: "argument order" };
                words = [contradiction, String::new()];
            }
        }
        outcome.note(judgement.class, asked.budget.findings_per_class, || {
            let [got, truth] = words;
            Finding::plain(judgement.class, judgement.check, vec![query(scene, content, pair)], got, truth)
        });
    }
    watch.done(0)?;
    let sides = match (zero, asked.backend.tie_judge()) {
        (ZeroMeaning::Never, Some(ties)) => Judged::perturbed(scene, ties),
        _ => Judged::exact(scene),
    };
    for (check, violation) in topology::violations(&sides, content.both(), found) {
        outcome.counts.add(Class::Topology, 1);
        outcome.findings.push(Finding::plain(Class::Topology, check, Vec::new(), violation, String::new()));
    }
    for level in &found.levels {
        outcome.row(&ContactRow {
            suite: case.loaded.suite.clone(),
            scene: case.loaded.name.clone(),
            scene_id: case.loaded.id.clone(),
            task: case.loaded.task.to_owned(),
            backend: asked.backend.name(),
            rank_a: level.ranks[0],
            rank_b: level.ranks[1],
            candidates: level.candidates,
            ended: level.ended,
            asked: level.asked,
            registered: level.registered,
        });
    }
    Ok(())
}

/// The agreement with the truth of the doubles and with that of the decimals.
///
/// The answers are all pairs that the backend or a truth registers. A pair is right if both register it, or neither.
pub(super) fn agreement(truths: [&Truth; 2], found: &Registered) -> Agreement {
    let got: BTreeSet<Pair> = found.registered.iter().map(|contact| [contact.a, contact.b]).collect();
    let is_judged = |[s, _]: &&Pair| truths.iter().all(|truth| truth.sampled.contains(s));
    let said = truths.iter().flat_map(|truth| &truth.registered).chain(&got);
    let all: BTreeSet<Pair> = said.filter(is_judged).copied().collect();
    let right = |truth: &Truth| {
        let is_right = |pair: &&Pair| got.contains(*pair) == truth.registered.contains(*pair);
        all.iter().filter(is_right).count() as u64
    };
    let [doubles, written] = truths.map(right);
    Agreement { answers: all.len() as u64, doubles, written, ..Agreement::default() }
}

fn has_nan(weights: &[Weights; 2]) -> bool {
    weights.as_flattened().iter().any(|weight| weight.is_nan())
}
