//! Every registered pair of two complexes against the truth.
//!
//! What is judged are the pairs that the truth or the backend registers; that a
//! pair is registered by neither is not counted as an answer, there are too many
//! of those. For backends that break ties the truth is, besides, what the
//! hierarchy registers with the signs of the perturbed scene.
//!
//! Whether a pair is registered depends on its faces alone. So one pair can be
//! asked about again by itself, and a sample of the truth is found twice, the
//! second time pair by pair and by the judge's other computation.

use std::collections::BTreeMap;

use predicament_algorithms::contacts::{Contacts as Registered, Weights, contacts};
use predicament_judge::Judged;
use predicament_mesh::Faces;
use predicament_predicates::{PredicateKind, Scene, ZeroMeaning};

use super::classes::{self, Judgement};
use super::pairs::{Pair, Pairs};
use super::section::ContactRow;
use super::{Complexes, Contacts, alone, band, order, query, topology, vertices_of};
use crate::{Asked, Case, Class, Finding, Outcome, Stop, Watch};

/// One registered pair in so many is found again, in another way.
const TWICE: usize = 16;
/// Orders of a pair's vertices, at most: what a pair costs of the budget for permutations.
const ORDERS: usize = 24;

/// The pairs that meet, exactly.
pub struct Truth {
    /// All of them.
    pub registered: Registered,
    faces: [Faces; 2],
}

impl Truth {
    /// Finds the truth.
    ///
    /// # Panics
    /// If the judge contradicts itself.
    pub(super) fn new(scene: &Scene, content: &Complexes, watch: &Watch) -> Result<Truth, Stop> {
        let registered = contacts(&Judged::exact(scene), &content.a, &content.b);
        watch.done((content.a.len() + content.b.len()) as u64)?;
        for contact in registered.registered.iter().step_by(TWICE) {
            let pair = [contact.a, contact.b];
            let again = alone(scene, content, &Judged::again(scene), pair);
            let same = again.registered.iter().any(|again| [again.a, again.b] == pair);
            assert!(same, "the judge contradicts itself about {}", query(scene, content, pair));
        }
        watch.done(0)?;
        Ok(Truth { registered, faces: content.both().map(Faces::new) })
    }

    fn pairs<'p>(&'p self, content: &'p Complexes, contacts: &Registered) -> Pairs<'p> {
        Pairs::new(content.both(), &self.faces, contacts)
    }
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
    let perturbed = match (zero, asked.backend.tie_judge()) {
        (ZeroMeaning::Never, Some(ties)) => Some(contacts(&Judged::perturbed(scene, ties), &content.a, &content.b)),
        _ => None,
    };
    watch.done(0)?;
    let [got, truth] = [found, &case.truth.registered].map(|contacts| case.truth.pairs(content, contacts));
    let perturbed = perturbed.as_ref().map(|contacts| case.truth.pairs(content, contacts));
    let audited = match zero {
        ZeroMeaning::Band => band::broken(session, content.both(), found, &got),
        ZeroMeaning::Exact | ZeroMeaning::Never => BTreeMap::new(),
    };
    watch.done(0)?;
    let perturbed = perturbed.as_ref();
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
        // A band's edges are fuzzy: another order of the arguments may round to its other side.
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

fn has_nan(weights: &[Weights; 2]) -> bool {
    weights.as_flattened().iter().any(|weight| weight.is_nan())
}
