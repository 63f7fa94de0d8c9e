//! The exact signs of all queries, with a sample computed twice.

use predicament_judge as judge;
use predicament_predicates::{QuerySet, Scene, Sign};
use rayon::prelude::*;

use super::CHUNK;
use crate::{Dispute, Stop, Watch};

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
    let mut signs = vec![Sign::Zero; queries.len()];
    let question = queries.question();
    let judge = judge::Points::of(scene);
    signs.par_chunks_mut(CHUNK).enumerate().try_for_each(|(chunk, signs)| {
        for (query, sign) in (chunk * CHUNK..).zip(&mut *signs) {
            let args = queries.args(query);
            *sign = judge.sign(question, args);
            if query.is_multiple_of(TWICE) {
                let again = judge.verdict(question, args).sign();
                assert_eq!(*sign, again, "the judge contradicts itself: {}", question.query(args));
            }
        }
        watch.done(signs.len() as u64)
    })?;
    Ok(signs)
}

/// Compares the published signs with the judge's.
pub(super) fn dispute(queries: &QuerySet, truth: &[Sign], expected: &[Sign]) -> Option<Dispute> {
    let mut wrong = (0..truth.len()).filter(|&i| truth[i] != expected[i]).peekable();
    let &first = wrong.peek()?;
    let query = queries.question().query(queries.args(first));
    let first = format!("{query} at query {first}: the data say {}, the judge {}", expected[first], truth[first]);
    Some(Dispute::Signs { count: wrong.count(), first })
}
