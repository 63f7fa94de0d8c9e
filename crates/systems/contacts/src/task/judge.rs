//! Every registered pair of two complexes against the truth.
//!
//! The truth is found by linear equations in rationals, all pairs whose boxes
//! meet; where that is too much, for every n-th simplex of the first complex. A
//! pair that a backend registers is judged in any case: the sample limits the
//! search for pairs that it has missed. What is judged are the pairs that the
//! truth or the backend registers; that a pair is registered by neither is not
//! counted as an answer, there are too many of those. For backends that break
//! ties the truth is, besides, what crosses in the perturbed scene.
//!
//! Whether a pair is registered depends on its faces alone. So one pair can be
//! asked about again by itself, and some pairs of the truth are found twice, the
//! second time by the hierarchy on the judge's signs.

use std::collections::{BTreeMap, BTreeSet};

use crate::algorithm::pairs::{Contacts as Registered, Weights};
use predicament_judge::{Judged, Sample, contacts as judge};
use predicament_mesh::{Complex, Faces, Simplex};
use predicament_predicates::{PredicateKind, Scene, Vertex, ZeroMeaning};

use super::classes::{self, Judgement};
use super::pairs::{Pair, Pairs};
use super::section::ContactRow;
use super::{Complexes, Contacts, alone, band, order, perturbed, query, topology, vertices_of};
use predicament_tasks::{Asked, Case, Class, Finding, Outcome, Stop, Watch};

/// One registered pair in so many is found again, in another way.
const TWICE: usize = 16;
/// Orders of a pair's vertices, at most: what a pair costs of the budget for permutations.
const ORDERS: usize = 24;

/// The pairs that meet, exactly.
pub struct Truth {
    /// Those of the sampled simplices of the first complex.
    registered: BTreeSet<Pair>,
    /// Which simplices of the first complex were looked at, by their place in [`simplices`].
    sample: Sample,
    /// Those simplices.
    sampled: BTreeSet<Simplex>,
    faces: [Faces; 2],
}

/// All simplices of a complex by rank, with their vertices.
pub(super) fn simplices(complex: &Complex) -> Vec<(Simplex, &[Vertex])> {
    let counts =
        [complex.vertices().len(), complex.edges().len(), complex.triangles().len(), complex.tetrahedra().len()];
    let of_rank = |(rank, count): (u8, usize)| {
        let count = u32::try_from(count).expect("a complex has fewer than 2^32 simplices");
        (0..count).map(move |index| Simplex { rank, index })
    };
    let all = (0..4).zip(counts).flat_map(of_rank);
    all.map(|simplex| (simplex, complex.vertices_of(simplex))).collect()
}

impl Truth {
    /// Finds the truth.
    ///
    /// # Panics
    /// If the judge contradicts itself.
    pub(super) fn new(scene: &Scene, content: &Complexes, watch: &Watch) -> Result<Truth, Stop> {
        let [a, b] = content.both().map(simplices);
        let [of_a, of_b]: [Vec<&[Vertex]>; 2] = [&a, &b].map(|all| all.iter().map(|&(_, vertices)| vertices).collect());
        let sample = judge::sample(scene.dimension(), [a.len(), b.len()]);
        let found = judge::contacts_of(scene, &of_a, &of_b, sample);
        let registered: BTreeSet<Pair> =
            found.iter().map(|contact| [a[contact.pair[0]].0, b[contact.pair[1]].0]).collect();
        watch.done((a.len() + b.len()) as u64)?;
        for &pair in registered.iter().step_by(TWICE) {
            let again = alone(scene, content, &Judged::again(scene), pair);
            let same = again.registered.iter().any(|again| [again.a, again.b] == pair);
            assert!(same, "the judge contradicts itself about {}", query(scene, content, pair));
        }
        watch.done(0)?;
        let sampled = sample.places().map(|place| a[place].0).collect();
        Ok(Truth { registered, sample, sampled, faces: content.both().map(Faces::new) })
    }

    /// How many simplices of the first complex were looked at, if not all.
    pub(super) fn sampled(&self) -> Option<String> {
        (!self.sample.is_all())
            .then(|| format!("simplices of the first complex: {}; and all registered pairs", self.sample))
    }

    fn pairs<'p>(&'p self, content: &'p Complexes, contacts: &Registered) -> Pairs<'p> {
        let pairs = contacts.registered.iter().map(|contact| [contact.a, contact.b]);
        Pairs::new(content.both(), &self.faces, pairs.collect())
    }

    /// The truth with everything that it takes to judge these pairs too, and their faces.
    fn about<'p>(&'p self, scene: &Scene, content: &'p Complexes, pairs: impl Iterator<Item = Pair>) -> Pairs<'p> {
        let mut registered = self.registered.clone();
        let [of_a, of_b] = &self.faces;
        let faces = pairs.flat_map(|[s, t]| of_a.of(s).flat_map(move |s| of_b.of(t).map(move |t| [s, t])));
        let unknown: BTreeSet<Pair> = faces.filter(|[s, _]| !self.sampled.contains(s)).collect();
        registered.extend(unknown.into_iter().filter(|&pair| {
            let [s, t] = vertices_of(content, pair);
            judge::contact(scene, s, t).is_some()
        }));
        Pairs::new(content.both(), &self.faces, registered)
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
    let got = case.truth.pairs(content, found);
    let perturbed = match (zero, asked.backend.tie_judge()) {
        (ZeroMeaning::Never, Some(ties)) => {
            let registered = perturbed::registered(scene, ties, content, &case.truth.sampled, got.iter(), watch)?;
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
    let truth = case.truth.about(scene, content, said);
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
