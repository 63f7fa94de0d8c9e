//! Judging of every answer by the truth, and of samples of answers by each other.
//!
//! The judged answer is the one given, in a batch or not. Samples are spread evenly over all queries.

use predicament_judge::{self as judge, TieJudge};
use predicament_laws::published;
use predicament_predicates::{Counts, Sign};
use rayon::prelude::*;

use super::class::{Given, class};
use super::error::{distance_over_l, largest_edge};
use super::{CHUNK, Signs, axioms, class};
use crate::{Asked, Budget, Case, Class, ClassCounts, Contestant, Finding, Outcome, Stop, symbol};

/// Judges all answers.
pub(super) fn judge(
    case: &Case<'_, Signs>,
    asked: &Asked<'_>,
    answers: &[Sign],
    outcome: &mut Outcome,
) -> Result<(), Stop> {
    let queries = &case.content.queries;
    let contract = asked.contract(queries.kind());
    let (scene, truth, session) = (case.scene(), case.truth.as_slice(), asked.session);
    let band = published::band(session, queries.question());
    let mut given = Given { scene, queries, truth, answers, session, contract, band, unstable: Vec::new() };
    given.ask_again(asked.budget, asked.watch)?;
    let ties = asked.backend.tie_judge();
    if asked.budget.answers {
        outcome.answers = class::lines(&given, ties, asked.backend);
    }
    let chunks: Result<Vec<Chunk>, Stop> = (0..queries.len().div_ceil(CHUNK))
        .into_par_iter()
        .map(|i| {
            let range = i * CHUNK..((i + 1) * CHUNK).min(queries.len());
            let chunk = judge_chunk(&given, ties, asked.budget, range);
            asked.watch.done(0).map(|()| chunk)
        })
        .collect();
    let mut raw: Vec<Raw> = Vec::new();
    let mut broken: Vec<u32> = Vec::new();
    for chunk in chunks? {
        outcome.counts.merge(&chunk.counts);
        raw.extend(chunk.raw);
        broken.extend(chunk.ties);
    }
    if let Some(perturbed) = ties {
        let wrong = wrongly_broken(&given, perturbed, &broken, asked.budget);
        outcome.counts.reclassify(Class::TieBroken, Class::SignFlip, wrong.len() as u64);
        raw.extend(wrong);
    }
    let mut kept = [0_usize; Class::ALL.len()];
    raw.retain(|raw| {
        let kept = &mut kept[raw.class as usize];
        *kept += 1;
        *kept <= asked.budget.findings_per_class
    });
    outcome.findings.extend(in_words(&given, asked.backend, &raw));
    let violations = axioms::check(&given, asked)?;
    for class in Class::ALL {
        outcome.counts.reclassify(class, Class::Inconsistent, violations.moved.get(class));
    }
    outcome.counts.add(Class::Inconsistent, violations.relations);
    outcome.findings.extend(violations.findings());
    Ok(())
}

/// A finding before its text is written.
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
    /// Queries whose tie was broken; a scene has fewer than 2^32 queries.
    ties: Vec<u32>,
}

fn judge_chunk(given: &Given<'_>, ties: Option<&TieJudge>, budget: Budget, range: std::ops::Range<usize>) -> Chunk {
    let mut chunk = Chunk { counts: ClassCounts::default(), raw: Vec::new(), ties: Vec::new() };
    for query in range {
        let class = class(given, ties, query);
        chunk.counts.add(class, 1);
        if class == Class::TieBroken && ties.is_some() {
            chunk.ties.push(u32::try_from(query).expect("a scene has fewer than 2^32 queries"));
        }
        if !class.is_legal() && chunk.counts.get(class) <= budget.findings_per_class as u64 {
            let check = match class {
                Class::Inconsistent => "never zero",
                Class::Unstable => "repeat",
                _ => "sign",
            };
            chunk.raw.push(Raw { class, check, query, got: given.answers[query], truth: given.truth[query] });
        }
    }
    chunk
}

/// Compares an even sample of broken ties with explicit infinitesimals. It uses the given signs, without new queries.
fn wrongly_broken(given: &Given<'_>, perturbed: &TieJudge, broken: &[u32], budget: Budget) -> Vec<Raw> {
    let question = given.queries.question();
    let sample: Vec<usize> = Budget::spread(broken.len(), 1, budget.ties).map(|at| broken[at] as usize).collect();
    sample
        .into_par_iter()
        .filter_map(|query| {
            let (got, truth) = (given.answers[query], perturbed(given.scene, question, given.queries.args(query)));
            (got != truth).then_some(Raw { class: Class::SignFlip, check: "perturbed sign", query, got, truth })
        })
        .collect()
}

/// The findings with their measures, and the stages that settle their queries alone.
fn in_words(given: &Given<'_>, backend: &dyn Contestant, raw: &[Raw]) -> Vec<Finding> {
    if raw.is_empty() {
        return Vec::new();
    }
    let question = given.queries.question();
    let l = largest_edge(given.scene);
    // The plan of the whole scene decides the stage, so the whole scene is prepared, once.
    let mut stages = vec![None; raw.len()];
    let counts = Counts::new();
    let settled =
        || -> Vec<u64> { (0..backend.stages().len()).map(|stage| counts.get(question.kind(), stage)).collect() };
    let prepared = backend.with_counted_session(given.scene, &counts, &mut |session| {
        for (stage, raw) in stages.iter_mut().zip(raw) {
            let before = settled();
            question.ask(session, given.queries.args(raw.query));
            let after = settled();
            *stage = backend.stages().iter().zip(before.iter().zip(&after)).find(|(_, (a, b))| a != b).map(|(&s, _)| s);
        }
    });
    // A backend that accepted the scene before accepts it again; otherwise findings have no stage.
    drop(prepared);
    let finding = |(raw, stage): (&Raw, Option<&'static str>)| {
        let args = given.queries.args(raw.query);
        let verdict = judge::verdict(given.scene, question, args);
        // The nearest double or infinity: for display.
        let nearest = verdict.determinant.to_f64();
        Finding {
            class: raw.class,
            check: raw.check.to_owned(),
            queries: vec![question.query(args)],
            got: [Some(raw.got), given.second(raw.query)].into_iter().flatten().map(Sign::symbol).collect(),
            truth: symbol(raw.truth),
            log2_relative_det: judge::log2_relative(&verdict),
            distance_over_l: distance_over_l(given.scene, question, args, nearest, l),
            stage,
        }
    };
    raw.iter().zip(stages).map(finding).collect()
}
