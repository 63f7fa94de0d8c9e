//! Sign scenes: every answer against the truth, and samples of answers against each other.

use predicament_predicates::{
    Backend, Contract, Counts, Off, PredicateKind, Predicates, QuerySet, Question, Scene, Sign, Vertex,
};
use rayon::prelude::*;
use rug::Rational;

use crate::axioms;
use crate::error::{distance_over_l, largest_edge};
use crate::outcome::{Finding, Outcome, symbol};
use crate::{Class, ClassCounts, Stop, Watch, classify, prepared};
use predicament_judge::{self as judge, TieJudge};

/// Queries to a chunk: small enough to stop soon, large enough to cost nothing.
const CHUNK: usize = 4096;

/// One of so many queries is judged twice, the second time in rationals.
const TWICE: usize = 1024;

/// A scene whose answers are signs, with the truth beside it.
pub struct SignCase<'a> {
    /// The points.
    pub scene: &'a Scene,
    /// The questions.
    pub queries: &'a QuerySet,
    /// The exact signs, from [`truth`].
    pub truth: &'a [Sign],
}

/// How much is asked beyond the queries themselves. All samples are spread
/// evenly and by index only, so they are the same in every run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Budget {
    /// Findings kept per class; all are counted.
    pub findings_per_class: usize,
    /// Evaluations spent on argument permutations.
    pub permutations: usize,
    /// Tuples tried for relations between answers (Grassmann-Plücker, transitivity).
    pub relations: usize,
    /// Whether all laws are tried that apply: the relations of circles and
    /// spheres and the mixed ones too, in all planes, of single calls and
    /// batches, of the scene and its first half.
    pub thorough: bool,
    /// Broken ties held against explicit infinitesimals.
    pub ties: usize,
}

impl Budget {
    /// Seconds for all embedded corpora: samples only.
    pub const QUICK: Budget =
        Budget { findings_per_class: 25, permutations: 5_000, relations: 500, thorough: false, ties: 50 };
    /// Every permutation of every query up to 24 million evaluations a scene.
    pub const FULL: Budget =
        Budget { findings_per_class: 25, permutations: 24_000_000, relations: 50_000, thorough: true, ties: 2_000 };
}

/// The exact signs of all queries, those of an even sample found twice.
///
/// # Errors
/// [`Stop`] where the watch says so.
///
/// # Panics
/// If the judge contradicts itself.
pub fn truth(scene: &Scene, queries: &QuerySet, watch: &Watch) -> Result<Vec<Sign>, Stop> {
    let mut signs = vec![Sign::Zero; queries.len()];
    let (question, points) = (queries.question(), judge::Points::of(scene));
    signs.par_chunks_mut(CHUNK).enumerate().try_for_each(|(chunk, signs)| {
        for (query, sign) in (chunk * CHUNK..).zip(&mut *signs) {
            let args = queries.args(query);
            *sign = points.sign(question, args);
            if query.is_multiple_of(TWICE) {
                let again = points.verdict(question, args).sign();
                assert_eq!(*sign, again, "the judge contradicts itself: {}", question.describe(args));
            }
        }
        watch.done(signs.len() as u64)
    })?;
    Ok(signs)
}

fn chunks(queries: usize) -> impl IndexedParallelIterator<Item = std::ops::Range<usize>> {
    (0..queries.div_ceil(CHUNK)).into_par_iter().map(move |i| i * CHUNK..((i + 1) * CHUNK).min(queries))
}

/// Runs one backend on one sign scene.
///
/// # Errors
/// [`Stop`] where the watch says so; nothing of this scene is kept then.
pub fn run<B: Backend>(
    backend: &B,
    tie_judge: Option<&TieJudge>,
    case: &SignCase,
    budget: Budget,
    watch: &Watch,
) -> Result<Outcome, Stop> {
    let queries = case.queries.len() as u64;
    let kind = case.queries.kind();
    let counts = Counts::new();
    let session = match prepared::session(backend, case.scene, &counts, |session| session.supports(kind)) {
        Ok(session) => session,
        Err(refusal) => return Ok(refusal.outcome(queries)),
    };
    let contract = backend.contract(kind);
    let chunks: Result<Vec<Chunk>, Stop> = chunks(case.queries.len())
        .map(|range| {
            let n = range.len() as u64;
            let chunk = judge_chunk(&session, contract, tie_judge, case, budget, range);
            watch.done(n).map(|()| chunk)
        })
        .collect();
    let mut counts_by_class = ClassCounts::default();
    let mut raw: Vec<Raw> = Vec::new();
    let mut ties = Vec::new();
    for chunk in chunks? {
        counts_by_class.merge(&chunk.counts);
        raw.extend(chunk.raw);
        ties.extend(chunk.ties);
    }
    // Counted before the checks below ask their own questions.
    let stages = prepared::stages(backend, &counts, &[kind]);

    let mut findings = Vec::new();
    if let Some(perturbed) = tie_judge {
        wrongly_broken(case, perturbed, &session, &ties, budget, &mut counts_by_class, &mut raw);
    }
    let mut kept = [0_usize; Class::ALL.len()];
    raw.retain(|raw| {
        let kept = &mut kept[raw.class as usize];
        *kept += 1;
        *kept <= budget.findings_per_class
    });
    if !raw.is_empty() {
        let describe = Describe::new(backend, case);
        findings.extend(raw.iter().map(|raw| describe.finding(raw)));
    }
    let violations = axioms::check(backend, &session, contract, case, budget, watch)?;
    for class in Class::ALL {
        counts_by_class.reclassify(class, Class::Inconsistent, violations.moved.get(class));
    }
    counts_by_class.add(Class::Inconsistent, violations.relations);
    findings.extend(violations.findings());
    Ok(Outcome { queries, counts: counts_by_class, findings, stages, ..Outcome::default() })
}

/// A finding before it is put into words.
struct Raw {
    class: Class,
    check: &'static str,
    query: usize,
    got: Sign,
    truth: Sign,
}

struct Chunk {
    counts: ClassCounts,
    raw: Vec<Raw>,
    /// Queries whose tie was broken.
    ties: Vec<usize>,
}

/// The class of one query.
pub(crate) fn class_of<P: Predicates>(session: &P, contract: Contract, case: &SignCase, query: usize) -> Class {
    let question = case.queries.question();
    class_of_answer(session, contract, case, query, question.ask(session, case.queries.args(query)))
}

fn class_of_answer<P: Predicates>(session: &P, contract: Contract, case: &SignCase, query: usize, got: Sign) -> Class {
    let question = case.queries.question();
    let (args, truth) = (case.queries.args(query), case.truth[query]);
    // A NaN compares as zero, so only zeros can hide one.
    if got.is_zero() && session.estimate(question, args).is_some_and(f64::is_nan) {
        return Class::Nan;
    }
    let band = session.band(question);
    classify(contract.zero, band, got, truth, || judge::verdict(case.scene, question, args))
}

fn judge_chunk<P: Predicates>(
    session: &P,
    contract: Contract,
    tie_judge: Option<&TieJudge>,
    case: &SignCase,
    budget: Budget,
    range: std::ops::Range<usize>,
) -> Chunk {
    let mut answers = vec![Sign::Zero; range.len()];
    case.queries.ask_batch(session, range.clone(), &mut answers);
    let mut chunk = Chunk { counts: ClassCounts::default(), raw: Vec::new(), ties: Vec::new() };
    for (query, got) in range.zip(answers) {
        let mut class = class_of_answer(session, contract, case, query, got);
        if class == Class::Inconsistent && is_identity(tie_judge, case, query) {
            class = Class::Agree;
        }
        chunk.counts.add(class, 1);
        if class == Class::TieBroken && chunk.ties.len() < budget.ties {
            chunk.ties.push(query);
        }
        let seen = chunk.counts.get(class);
        if !class.is_legal() && seen <= budget.findings_per_class as u64 {
            let check = if class == Class::Inconsistent { "never zero" } else { "sign" };
            chunk.raw.push(Raw { class, check, query, got, truth: case.truth[query] });
        }
    }
    chunk
}

/// Whether a determinant is zero however the scene moves: no tie, but a vertex
/// on the plane it was constructed on, two names of one point, or vertices of
/// one mesh that is moved as a whole.
fn is_identity(tie_judge: Option<&TieJudge>, case: &SignCase, query: usize) -> bool {
    let (question, args) = (case.queries.question(), case.queries.args(query));
    tie_judge.is_some_and(|perturbed| perturbed(case.scene, question, args).is_zero())
}

/// Holds a sample of broken ties against explicit infinitesimals.
fn wrongly_broken<P: Predicates>(
    case: &SignCase,
    perturbed: &TieJudge,
    session: &P,
    ties: &[usize],
    budget: Budget,
    counts: &mut ClassCounts,
    raw: &mut Vec<Raw>,
) {
    let question = case.queries.question();
    let step = ties.len().div_ceil(budget.ties.max(1)).max(1);
    let wrong: Vec<Raw> = ties
        .par_iter()
        .step_by(step)
        .filter_map(|&query| {
            let args = case.queries.args(query);
            let (got, truth) = (question.ask(session, args), perturbed(case.scene, question, args));
            (got != truth).then_some(Raw { class: Class::SignFlip, check: "perturbed sign", query, got, truth })
        })
        .collect();
    counts.reclassify(Class::TieBroken, Class::SignFlip, wrong.len() as u64);
    raw.extend(wrong);
}

/// Puts findings into words: prepares a second session whose counts tell the stage.
struct Describe<'a, B> {
    backend: &'a B,
    case: &'a SignCase<'a>,
    l: f64,
}

impl<'a, B: Backend> Describe<'a, B> {
    fn new(backend: &'a B, case: &'a SignCase<'a>) -> Self {
        Describe { backend, case, l: largest_edge(case.scene) }
    }

    fn finding(&self, raw: &Raw) -> Finding {
        let (scene, question) = (self.case.scene, self.case.queries.question());
        let args = self.case.queries.args(raw.query);
        let verdict = judge::verdict(scene, question, args);
        Finding {
            class: raw.class,
            check: raw.check.to_owned(),
            query: question.describe(args),
            got: symbol(raw.got),
            truth: symbol(raw.truth),
            log2_relative_det: judge::log2_relative(&verdict),
            distance_over_l: distance_over_l(scene, question, args, nearest(&verdict.determinant), self.l),
            stage: stage_of(self.backend, scene, question, args),
        }
    }
}

/// The nearest double or infinity: for display.
fn nearest(x: &Rational) -> f64 {
    x.to_f64()
}

/// The stage that settles a query, by asking it alone.
pub fn stage_of<B: Backend>(backend: &B, scene: &Scene, question: Question, args: &[Vertex]) -> Option<&'static str> {
    // Only the vertices of the query matter for the answer, but the plan of the
    // whole scene decides the stage, so the whole scene is prepared.
    let counts = Counts::new();
    let session = backend.prepare(scene, &counts).ok()?;
    question.ask(&session, args);
    let kind: PredicateKind = question.kind();
    backend.stages().iter().enumerate().find(|&(stage, _)| counts.get(kind, stage) > 0).map(|(_, &name)| name)
}

/// All answers of a backend, in order: for pictures and for verified timing.
///
/// # Errors
/// The reason, where the backend declines.
pub fn answers<B: Backend>(backend: &B, scene: &Scene, queries: &QuerySet) -> Result<Vec<Sign>, String> {
    let session = prepared::session(backend, scene, Off, |session| session.supports(queries.kind()))?;
    let mut out = vec![Sign::Zero; queries.len()];
    out.par_chunks_mut(CHUNK).enumerate().for_each(|(i, out)| {
        queries.ask_batch(&session, i * CHUNK..i * CHUNK + out.len(), out);
    });
    Ok(out)
}
