//! The answers to a scene, the class of each, and the record of each.
//!
//! An answer is compared with the exact sign, and with the backend's own promise. Every query is in exactly one class.

use predicament_judge::{self as judge, TieJudge};
use predicament_predicates::{Band, Class, Contract, Counts, Predicates, QuerySet, Scene, Sign, ZeroMeaning};
use rayon::prelude::*;

use super::CHUNK;
use crate::{AnswerLine, Budget, Contestant, Stop, Watch, symbol};

/// Classifies one answer. `is_within` returns true if the determinant has at most a given magnitude; it is called only
/// if that matters (backends with a band).
#[must_use]
pub fn classify(
    zero: ZeroMeaning,
    band: Option<Band>,
    answer: Sign,
    truth: Sign,
    is_within: impl FnOnce(f64) -> bool,
) -> Class {
    match (answer, truth) {
        (Sign::Zero, Sign::Zero) => match zero {
            ZeroMeaning::Never => Class::Inconsistent,
            ZeroMeaning::Exact | ZeroMeaning::Band => Class::Agree,
        },
        (Sign::Zero, _) => match band {
            Some(band) if is_within(band.upper) => Class::InBand,
            _ => Class::Overreach,
        },
        (_, Sign::Zero) => match zero {
            ZeroMeaning::Never => Class::TieBroken,
            ZeroMeaning::Exact | ZeroMeaning::Band => Class::MissedZero,
        },
        (answer, truth) if answer != truth => Class::SignFlip,
        _ => match band {
            Some(band) if is_within(band.lower) => Class::MissedZero,
            _ => Class::Agree,
        },
    }
}

/// The answers to a scene with all the data to judge them.
pub(super) struct Given<'a> {
    pub scene: &'a Scene,
    pub queries: &'a QuerySet,
    pub truth: &'a [Sign],
    pub answers: &'a [Sign],
    pub session: &'a dyn Predicates,
    pub contract: Contract,
    /// The published band that applies to the answers; `None` if the backend claims none.
    pub band: Option<Band>,
    /// Queries that got another answer when they were asked again, in order, with that answer.
    pub unstable: Vec<(usize, Sign)>,
}

impl Given<'_> {
    /// The class of the answer that was given to a query.
    pub(super) fn class(&self, query: usize) -> Class {
        if self.second(query).is_some() {
            return Class::Unstable;
        }
        let question = self.queries.question();
        let (args, got, truth) = (self.queries.args(query), self.answers[query], self.truth[query]);
        // A NaN compares as zero, so only zeros can hide one.
        if got.is_zero() && self.session.estimate(question, args).is_some_and(f64::is_nan) {
            return Class::Nan;
        }
        classify(self.contract.zero, self.band, got, truth, |limit| judge::is_within(self.scene, question, args, limit))
    }
}

impl Given<'_> {
    /// The second answer to a query, if it differs from the first.
    pub(super) fn second(&self, query: usize) -> Option<Sign> {
        let at = self.unstable.binary_search_by_key(&query, |&(query, _)| query).ok()?;
        Some(self.unstable[at].1)
    }

    /// Asks an even sample of the queries again, beside other queries than at first, and keeps the answers that differ.
    /// The sample is a fifth of the relations' number: it then takes about a hundredth of the laws' time.
    pub(super) fn ask_again(&mut self, budget: Budget, watch: &Watch) -> Result<(), Stop> {
        let sample: Vec<usize> = Budget::spread(self.queries.len(), 1, budget.relations / 5).collect();
        let args = sample.iter().flat_map(|&query| self.queries.args(query)).copied().collect();
        let again = QuerySet::new(self.queries.question(), args);
        let mut answers = vec![Sign::Zero; sample.len()];
        answers.par_chunks_mut(CHUNK).enumerate().try_for_each(|(chunk, out)| {
            again.ask_batch(self.session, chunk * CHUNK..chunk * CHUNK + out.len(), out);
            watch.done(0)
        })?;
        let pairs = sample.into_iter().zip(answers);
        self.unstable = pairs.filter(|&(query, answer)| answer != self.answers[query]).collect();
        Ok(())
    }
}

/// The class of the answer to a query. If ties are broken, zero is right for an identity.
pub(super) fn class(given: &Given<'_>, ties: Option<&TieJudge>, query: usize) -> Class {
    match given.class(query) {
        Class::Inconsistent if is_identity(given, ties, query) => Class::Agree,
        class => class,
    }
}

/// True if a determinant is zero under every perturbation. It is not a tie, but a vertex on the plane it was
/// constructed on, two names of one point, or vertices of one mesh that moves as a whole.
fn is_identity(given: &Given<'_>, ties: Option<&TieJudge>, query: usize) -> bool {
    let (question, args) = (given.queries.question(), given.queries.args(query));
    ties.is_some_and(|perturbed| perturbed(given.scene, question, args).is_zero())
}

/// The records of all answers, in query order.
pub(super) fn lines(given: &Given<'_>, ties: Option<&TieJudge>, backend: &dyn Contestant) -> Vec<AnswerLine> {
    let classes: Vec<Class> = (0..given.queries.len()).into_par_iter().map(|query| class(given, ties, query)).collect();
    let stages = stages(given, backend);
    let line = |(query, (class, stage)): (usize, (Class, &'static str))| AnswerLine {
        query,
        args: given.queries.args(query).to_vec(),
        answer: symbol(given.answers[query]),
        exact: symbol(given.truth[query]),
        class,
        stage,
    };
    classes.into_iter().zip(stages).enumerate().map(line).collect()
}

/// The stage of each query, evaluated alone in the whole scene.
fn stages(given: &Given<'_>, backend: &dyn Contestant) -> Vec<&'static str> {
    let (question, counts) = (given.queries.question(), Counts::new());
    let names = backend.stages();
    let settled = || (0..names.len()).map(|stage| counts.get(question.kind(), stage)).collect::<Vec<u64>>();
    let mut stages = vec![""; given.queries.len()];
    let prepared = backend.with_counted_session(given.scene, &counts, &mut |session| {
        let mut before = settled();
        for (query, stage) in stages.iter_mut().enumerate() {
            question.ask(session, given.queries.args(query));
            let after = settled();
            if let Some(at) = (0..names.len()).find(|&at| before[at] != after[at]) {
                *stage = names[at];
            }
            before = after;
        }
    });
    // A backend that accepted the scene before accepts it again; otherwise answers have no stage.
    drop(prepared);
    stages
}

#[cfg(test)]
mod tests {
    use super::*;
    use Sign::{Negative, Positive, Zero};

    const BAND: Option<Band> = Some(Band { lower: 1.0, width: 2.0, upper: 3.0 });

    fn of(zero: ZeroMeaning, band: Option<Band>, answer: Sign, determinant: f64) -> Class {
        classify(zero, band, answer, Sign::of(determinant), |limit| determinant.abs() <= limit)
    }

    #[test]
    fn each_promise_has_its_own_legal_disagreement() {
        use ZeroMeaning::{Band as InBand, Exact, Never};
        assert_eq!(of(Exact, None, Zero, 0.0), Class::Agree);
        assert_eq!(of(Never, None, Zero, 0.0), Class::Inconsistent);
        assert_eq!(of(Exact, None, Positive, 0.0), Class::MissedZero);
        assert_eq!(of(Never, None, Positive, 0.0), Class::TieBroken);
        assert_eq!(of(InBand, BAND, Positive, 0.0), Class::MissedZero);
        assert_eq!(of(Exact, None, Zero, 0.5), Class::Overreach);
        assert_eq!(of(Never, None, Zero, -0.5), Class::Overreach);
        for zero in [Exact, Never, InBand] {
            assert_eq!(of(zero, None, Positive, -5.0), Class::SignFlip);
            assert_eq!(of(zero, None, Negative, -5.0), Class::Agree);
        }
    }

    #[test]
    fn a_band_is_held_to_both_of_its_edges() {
        let of = |answer, determinant| of(ZeroMeaning::Band, BAND, answer, determinant);
        assert_eq!(of(Zero, 3.0), Class::InBand);
        assert_eq!(of(Zero, -3.000_001), Class::Overreach);
        assert_eq!(of(Positive, 1.000_001), Class::Agree);
        assert_eq!(of(Positive, 1.0), Class::MissedZero);
        assert_eq!(of(Negative, 1.0), Class::SignFlip);
    }
}
