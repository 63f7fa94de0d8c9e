//! The exact signs of all queries, with a sample computed twice.

use predicament_formats::Written;
use predicament_judge as judge;
use predicament_predicates::{QuerySet, Scene, Sign, Vertex};
use rayon::prelude::*;

use super::CHUNK;
use crate::{Agreement, Class, Dispute, Outcome, Stop, Watch};

/// The stride of queries that are judged twice, the second time in rationals.
const TWICE: usize = 1024;

/// The exact signs of all queries; an evenly spread sample is computed twice.
///
/// # Errors
/// [`Stop`] if the watch stops the computation.
///
/// # Panics
/// If the judge contradicts itself.
pub fn truth(scene: &Scene, queries: &QuerySet, watch: &Watch) -> Result<Vec<Sign>, Stop> {
    let judge = judge::Points::of(scene);
    let question = queries.question();
    all(queries, watch, |args| judge.sign(question, args), |args| judge.verdict(question, args).sign())
}

/// The exact signs of all queries about the decimals that were written; a sample is computed twice.
pub(super) fn as_written(
    scene: &Scene,
    queries: &QuerySet,
    written: &Written,
    watch: &Watch,
) -> Result<Vec<Sign>, Stop> {
    let judge = judge::Decimals::new(scene, written.digits(), written.numerators());
    let question = queries.question();
    all(queries, watch, |args| judge.sign(question, args), |args| judge.verdict(question, args).sign())
}

/// All signs by the first way, and an evenly spread sample by both.
fn all(
    queries: &QuerySet,
    watch: &Watch,
    first: impl Fn(&[Vertex]) -> Sign + Sync,
    second: impl Fn(&[Vertex]) -> Sign + Sync,
) -> Result<Vec<Sign>, Stop> {
    let mut signs = vec![Sign::Zero; queries.len()];
    signs.par_chunks_mut(CHUNK).enumerate().try_for_each(|(chunk, signs)| {
        for (query, sign) in (chunk * CHUNK..).zip(&mut *signs) {
            let args = queries.args(query);
            *sign = first(args);
            if query.is_multiple_of(TWICE) {
                let again = second(args);
                assert_eq!(*sign, again, "the judge contradicts itself: {}", queries.question().query(args));
            }
        }
        watch.done(signs.len() as u64)
    })?;
    Ok(signs)
}

/// The agreement of answers with both truths; `own` is their outcome about the doubles.
pub(super) fn agreement(written: &[Sign], answers: &[Sign], own: &Outcome) -> Agreement {
    let both = || answers.iter().zip(written);
    let is_tie = |(_, truth): &(&Sign, &Sign)| truth.is_zero();
    let count = |n: usize| n as u64;
    Agreement {
        answers: count(answers.len()),
        doubles: own.counts.get(Class::Agree),
        written: count(both().filter(|(answer, truth)| answer == truth).count()),
        ties: count(both().filter(is_tie).count()),
        ties_found: count(both().filter(is_tie).filter(|(answer, _)| answer.is_zero()).count()),
    }
}

/// Compares the published signs with the judge's.
pub(super) fn dispute(queries: &QuerySet, truth: &[Sign], expected: &[Sign]) -> Option<Dispute> {
    let mut wrong = (0..truth.len()).filter(|&i| truth[i] != expected[i]).peekable();
    let &first = wrong.peek()?;
    let query = queries.question().query(queries.args(first));
    let first = format!("{query} at query {first}: the data say {}, the judge {}", expected[first], truth[first]);
    Some(Dispute::Signs { count: wrong.count(), first })
}
