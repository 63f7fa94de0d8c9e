//! Contacts: every registered pair of two complexes against the truth.
//!
//! The truth is what the same hierarchy registers with the judge's signs: the
//! common points of closed simplices, each by its carriers of the lowest
//! dimension. For backends that break ties it is, besides, what the hierarchy
//! registers with the signs of the perturbed scene. What is judged are the
//! pairs that the truth or the backend registers; that a pair is registered by
//! neither is not counted as an answer, there are too many of those.
//!
//! Whether a pair is registered depends on its faces alone. So one pair can be
//! asked about again by itself, and a sample of the truth is found twice, the
//! second time pair by pair and by the judge's other computation.

mod band;
mod classes;
mod order;
mod pairs;
mod topology;

use std::collections::BTreeMap;
use std::hint::black_box;
use std::time::{Duration, Instant};

use predicament_algorithms::contacts::{Contact, Contacts, Weights, contacts};
use predicament_mesh::{Complex, Faces, Simplex};
use predicament_predicates::{Backend, Counts, Off, PredicateKind, Predicates, Scene, Vertex, ZeroMeaning};

use crate::contestant::{Stopwatch, digest};
use crate::outcome::{Finding, Outcome};
use crate::signs::Budget;
use crate::{Class, Stop, Watch, prepared};
use classes::Judgement;
pub(crate) use pairs::Pair;
use pairs::{Pairs, closure, name};
use predicament_judge::{Judged, TieJudge};

/// The predicates that contacts ask, unless the backend answers them itself.
const ASKED: [PredicateKind; 3] = [PredicateKind::Compare, PredicateKind::Orient2d, PredicateKind::Orient3d];
/// One registered pair in so many is found again, in another way.
const TWICE: usize = 16;

/// Two complexes, and what is true about them.
pub struct ContactsCase<'a> {
    scene: Scene,
    complexes: [&'a Complex; 2],
    faces: [Faces; 2],
    truth: Contacts,
}

impl<'a> ContactsCase<'a> {
    /// Finds the truth.
    ///
    /// # Errors
    /// [`Stop`] where the watch says so.
    ///
    /// # Panics
    /// If the judge contradicts itself.
    pub fn new(scene: &Scene, a: &'a Complex, b: &'a Complex, watch: &Watch) -> Result<ContactsCase<'a>, Stop> {
        let lengths = [a, b].map(|complex| complex.primitive_length(scene));
        let scene = scene.clone().with_primitive_lengths(lengths).with_second_mesh(b.vertices().iter().copied());
        let truth = contacts(&Judged::exact(&scene), a, b);
        watch.done((a.len() + b.len()) as u64)?;
        let case = ContactsCase { scene, complexes: [a, b], faces: [a, b].map(Faces::new), truth };
        for contact in case.truth.registered.iter().step_by(TWICE) {
            let pair = [contact.a, contact.b];
            let again = case.alone(&Judged::again(&case.scene), pair);
            let same = again.registered.iter().any(|again| [again.a, again.b] == pair);
            assert!(same, "the judge contradicts itself about {}", case.describe(pair));
        }
        watch.done(0)?;
        Ok(case)
    }

    /// The scene, with the lengths of the primitives.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Both complexes.
    #[must_use]
    pub fn complexes(&self) -> [&'a Complex; 2] {
        self.complexes
    }

    /// The pairs that meet, exactly.
    #[must_use]
    pub fn truth(&self) -> &Contacts {
        &self.truth
    }

    /// The number of simplices in both complexes.
    fn simplices(&self) -> u64 {
        self.complexes.iter().map(|complex| complex.len() as u64).sum()
    }

    fn pairs<'p>(&'p self, contacts: &Contacts) -> Pairs<'p> {
        Pairs::new(self.complexes, &self.faces, contacts)
    }

    fn vertices_of(&self, [s, t]: Pair) -> [&[Vertex]; 2] {
        let [a, b] = self.complexes;
        [a.vertices_of(s), b.vertices_of(t)]
    }

    /// A pair as text: `contacts2d(0 1, 4 5)`.
    fn describe(&self, pair: Pair) -> String {
        format!("contacts{}d({})", self.scene.dimension().count(), name(self.complexes, pair))
    }

    /// The contacts of one pair's faces, as complexes of their own.
    fn alone<S: Predicates>(&self, session: &S, pair: Pair) -> Contacts {
        let [s, t] = self.vertices_of(pair).map(|vertices| closure(&self.scene, vertices));
        let mut found = contacts(session, &s, &t);
        // From places in the two closures to places in the complexes.
        let [a, b] = self.complexes;
        let find = |all: &Complex, one: &Complex, simplex: Simplex| all.find(one.vertices_of(simplex));
        found.registered.retain_mut(|contact| {
            let places = find(a, &s, contact.a).zip(find(b, &t, contact.b));
            places.map(|(a, b)| (contact.a, contact.b) = (a, b)).is_some()
        });
        found
    }

    /// The pair with these vertices, one simplex of each complex.
    ///
    /// # Errors
    /// One line, where the complexes have no such simplices.
    pub fn find(&self, s: &[Vertex], t: &[Vertex]) -> Result<[Simplex; 2], String> {
        let [a, b] = self.complexes;
        let both = a.find(s).zip(b.find(t));
        both.map(|(s, t)| [s, t]).ok_or_else(|| "the complexes have no such pair of simplices".to_owned())
    }

    fn finding(&self, pair: Pair, judgement: Judgement, got: String, truth: String) -> Finding {
        Finding::plain(judgement.class, judgement.check, self.describe(pair), got, truth)
    }

    /// The exact answer about one pair, for `replay`.
    #[must_use]
    pub fn truth_about(&self, pair: [Simplex; 2]) -> String {
        self.tell(pair, &self.alone(&Judged::again(&self.scene), pair))
    }

    /// What a backend makes of one pair and its faces, for `replay`.
    ///
    /// # Errors
    /// The reason, where the backend declines.
    pub fn ask<B: Backend>(&self, backend: &B, pair: [Simplex; 2]) -> Result<String, String> {
        let session = prepare(backend, &self.scene)?;
        Ok(self.tell(pair, &self.alone(&session, pair)))
    }

    /// What is registered of a pair and its faces, with the weights.
    fn tell(&self, pair: Pair, contacts: &Contacts) -> String {
        if contacts.registered.is_empty() {
            return "apart".to_owned();
        }
        let one = |contact: &Contact| {
            let this = [contact.a, contact.b];
            let [s, t] = self.vertices_of(this).map(<[Vertex]>::len);
            let weights = |of: Weights, n: usize| of[..n].iter().map(|w| format!("{w}")).collect::<Vec<_>>().join(" ");
            let at = format!("at {}; {}", weights(contact.on_a, s), weights(contact.on_b, t));
            let what = if this == pair { "registered".to_owned() } else { format!("ended by {}", self.describe(this)) };
            format!("{what} {at}")
        };
        contacts.registered.iter().map(one).collect::<Vec<_>>().join(", ")
    }
}

fn prepare<'a, B: Backend>(backend: &'a B, scene: &'a Scene) -> Result<B::Session<'a, Off>, String> {
    Ok(prepared::session(backend, scene, Off, Predicates::supports_contacts)?)
}

/// Runs one backend on two complexes.
///
/// # Errors
/// [`Stop`] where the watch says so.
pub fn run<B: Backend>(
    backend: &B,
    tie_judge: Option<&TieJudge>,
    case: &ContactsCase,
    budget: Budget,
    watch: &Watch,
) -> Result<Outcome, Stop> {
    let queries = case.simplices();
    let counts = Counts::new();
    let session = match prepared::session(backend, &case.scene, &counts, Predicates::supports_contacts) {
        Ok(session) => session,
        Err(refusal) => return Ok(refusal.outcome(queries)),
    };
    let [a, b] = case.complexes;
    let dimension = case.scene.dimension();
    let zero = backend.contract(PredicateKind::Orient2d).zero;
    watch.done(0)?;
    let found = contacts(&session, a, b);
    watch.done(queries)?;
    // Counted before the checks below ask their own questions.
    let mut outcome = Outcome { queries, stages: prepared::stages(backend, &counts, &ASKED), ..Outcome::default() };

    let perturbed = match (zero, tie_judge) {
        (ZeroMeaning::Never, Some(ties)) => Some(contacts(&Judged::perturbed(&case.scene, ties), a, b)),
        _ => None,
    };
    watch.done(0)?;
    let [got, truth] = [&found, &case.truth].map(|contacts| case.pairs(contacts));
    let perturbed = perturbed.as_ref().map(|contacts| case.pairs(contacts));
    let audited = match zero {
        ZeroMeaning::Band => band::broken(&session, case.complexes, &found, &got),
        ZeroMeaning::Exact | ZeroMeaning::Never => BTreeMap::new(),
    };
    watch.done(0)?;
    let perturbed = perturbed.as_ref();
    let judge = classes::Judge { dimension, zero, got: &got, truth: &truth, perturbed, audited: &audited };
    let weights: BTreeMap<Pair, [Weights; 2]> =
        found.registered.iter().map(|contact| ([contact.a, contact.b], [contact.on_a, contact.on_b])).collect();
    let pairs = judge.pairs();
    let step = pairs.len().div_ceil((budget.permutations / ORDERS).max(1)).max(1);
    for (at, &pair) in pairs.iter().enumerate() {
        let mut judgement = judge.class(pair);
        let mut words = [got.say(pair), perturbed.unwrap_or(&truth).say(pair)];
        if judgement.class == Class::Agree && weights.get(&pair).is_some_and(has_nan) {
            judgement = Judgement { class: Class::Nan, check: "weights" };
        }
        // A band's edges are fuzzy: another order of the arguments may round to its other side.
        let asked = zero != ZeroMeaning::Band && at.is_multiple_of(step) && got.ended_by(pair).is_none();
        if judgement.class.is_legal() && asked {
            let [s, t] = case.vertices_of(pair);
            if let Some(contradiction) = order::contradiction(&session, s, t) {
                judgement = Judgement { class: Class::Inconsistent, check: "argument order" };
                words = [contradiction, String::new()];
            }
        }
        outcome.counts.add(judgement.class, 1);
        let kept = outcome.counts.get(judgement.class) <= budget.findings_per_class as u64;
        if !judgement.class.is_legal() && kept {
            let [got, truth] = words;
            outcome.findings.push(case.finding(pair, judgement, got, truth));
        }
    }
    watch.done(0)?;
    let sides = match (zero, tie_judge) {
        (ZeroMeaning::Never, Some(ties)) => Judged::perturbed(&case.scene, ties),
        _ => Judged::exact(&case.scene),
    };
    for (check, violation) in topology::violations(&sides, case.complexes, &found) {
        outcome.counts.add(Class::Topology, 1);
        outcome.findings.extend(Outcome::of_scene(0, Class::Topology, check, violation).findings);
    }
    outcome.contacts = found.levels;
    Ok(outcome)
}

/// Orders of a pair's vertices, at most: what a pair costs of the budget for permutations.
const ORDERS: usize = 24;

fn has_nan(weights: &[Weights; 2]) -> bool {
    weights.as_flattened().iter().any(|weight| weight.is_nan())
}

/// All contacts that a backend registers.
pub(crate) fn registered<B: Backend>(backend: &B, scene: &Scene, [a, b]: [&Complex; 2]) -> Result<Contacts, String> {
    let session = prepare(backend, scene)?;
    Ok(contacts(&session, a, b))
}

/// Prepares a backend for timed passes over both complexes on so many threads.
pub(crate) fn stopwatch<'a, B: Backend>(
    backend: &'a B,
    case: &'a ContactsCase,
    threads: usize,
) -> Result<Box<dyn Stopwatch + 'a>, String> {
    let session = prepare(backend, &case.scene)?;
    // The driver would use all there are.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().map_err(|error| error.to_string())?;
    Ok(Box::new(ContactsWatch { session, case, pool, out: Contacts::default() }))
}

struct ContactsWatch<'a, P> {
    session: P,
    case: &'a ContactsCase<'a>,
    pool: rayon::ThreadPool,
    out: Contacts,
}

impl<P: Predicates> Stopwatch for ContactsWatch<'_, P> {
    fn pass(&mut self) -> Duration {
        let [a, b] = self.case.complexes;
        let (time, out) = self.pool.install(|| {
            let start = Instant::now();
            let out = contacts(&self.session, a, b);
            (start.elapsed(), out)
        });
        self.out = black_box(out);
        time
    }

    fn digest(&self) -> u64 {
        digest_of(&self.out)
    }
}

/// The digest of known answers, for comparison with [`Stopwatch::digest`].
#[must_use]
pub fn digest_of(contacts: &Contacts) -> u64 {
    let simplex = |simplex: Simplex| [u32::from(simplex.rank), simplex.index];
    let pairs = contacts.registered.iter().flat_map(|contact| [contact.a, contact.b]);
    digest(pairs.flat_map(simplex).flat_map(u32::to_le_bytes))
}
