//! Query orders of one predicate that a branch predictor cannot learn.
//!
//! A processor learns the answers of a few thousand queries that repeat in the same order; code that branches on signs
//! then looks several times faster than on new input. So each round evaluates all queries of a scene in a different
//! random order, and rounds are joined until the clock measures [`PLENTY`] queries at once. A scene with that many
//! queries is evaluated in its own order: a predictor holds fewer.

use std::time::Duration;

use predicament_corpus::Random;
use predicament_predicates::Sign;

use crate::Answer;
use crate::signs::Answers;

/// The number of queries that a predictor cannot learn, whatever their order.
pub const PLENTY: usize = 200_000;

/// The orders in which the queries of one scene are timed, and a check that all rounds gave the same answers.
pub struct Rounds {
    /// The number of queries of the scene.
    queries: usize,
    random: Random,
    /// The indices of the queries that are timed together, round after round; empty if they are evaluated in their own
    /// order.
    order: Vec<u32>,
    /// The answers to these, in the order of evaluation.
    signs: Vec<Sign>,
    /// The answers of the first round, in the scene's order.
    answers: Answers,
    /// True if a later round gave different answers.
    differ: bool,
}

impl Rounds {
    /// The state before the first round, for a number of queries.
    #[must_use]
    pub fn of(queries: usize) -> Rounds {
        Rounds {
            queries,
            random: Random::new("rounds", "bench", queries as u64),
            order: Vec::new(),
            signs: Vec::new(),
            answers: Answers::default(),
            differ: false,
        }
    }

    /// The time of `count` rounds. `ask` gets the indices of the queries, or `None` for all in the scene's order. It
    /// arranges the queries, evaluates them between two readings of a clock, and returns the time.
    pub fn time(&mut self, count: u32, mut ask: impl FnMut(Option<&[u32]>, &mut [Sign]) -> Duration) -> Duration {
        let together = if self.queries == 0 { 1 } else { PLENTY.div_ceil(self.queries) };
        let (mut left, mut total) = (count as usize, Duration::ZERO);
        while left > 0 {
            let rounds = left.min(together);
            self.shuffle(rounds);
            total += ask((!self.order.is_empty()).then_some(&self.order), &mut self.signs);
            self.verify();
            left -= rounds;
        }
        total
    }

    /// A digest of the answers in the scene's order; if rounds differed, the digest of an empty list.
    #[must_use]
    pub fn digest(&self) -> u64 {
        if self.differ { !self.answers.digest() } else { self.answers.digest() }
    }

    /// Makes orders for `rounds` rounds.
    fn shuffle(&mut self, rounds: usize) {
        self.signs.resize(rounds * self.queries, Sign::Zero);
        if self.queries >= PLENTY {
            return;
        }
        #[allow(clippy::cast_possible_truncation)] // fewer than `PLENTY`
        let all = 0..self.queries as u32;
        self.order.clear();
        for _ in 0..rounds {
            let start = self.order.len();
            self.order.extend(all.clone());
            self.random.shuffle(&mut self.order[start..]);
        }
    }

    /// Compares the answers of all rounds with those of the first.
    fn verify(&mut self) {
        let Rounds { queries, order, signs, answers: Answers(answers), differ, .. } = self;
        let is_first = answers.is_empty();
        if is_first {
            answers.resize(*queries, Sign::Zero);
        }
        if order.is_empty() {
            match is_first {
                true => answers.copy_from_slice(&signs[..*queries]),
                false => *differ |= signs != answers,
            }
            return;
        }
        if is_first {
            order.iter().zip(&*signs).take(*queries).for_each(|(&at, &sign)| answers[at as usize] = sign);
        }
        let differs = order.iter().zip(&*signs).any(|(&at, &sign)| answers[at as usize] != sign);
        *differ |= differs;
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    const SIGNS: [Sign; 3] = [Sign::Negative, Sign::Zero, Sign::Positive];

    /// Answers like a backend whose signs depend on the query alone, and keeps the orders of evaluation.
    fn time(rounds: &mut Rounds, count: u32, mut keep: impl FnMut(&[u32])) {
        let queries = rounds.queries;
        rounds.time(count, |order, out| {
            let own: Vec<u32> = (0..u32::try_from(queries).unwrap()).collect();
            let order = order.unwrap_or(&own);
            assert_eq!(order.len(), out.len());
            keep(order);
            order.iter().zip(out).for_each(|(&at, out)| *out = SIGNS[at as usize % 3]);
            Duration::from_nanos(order.len() as u64)
        });
    }

    fn judged(queries: usize) -> u64 {
        Answers((0..queries).map(|at| SIGNS[at % 3]).collect()).digest()
    }

    #[test]
    fn no_two_rounds_have_one_order_and_each_asks_everything() {
        let mut rounds = Rounds::of(1000);
        let mut orders = Vec::new();
        time(&mut rounds, 1, |order| orders.push(order.to_vec()));
        time(&mut rounds, 450, |order| orders.extend(order.chunks(1000).map(<[u32]>::to_vec)));
        assert_eq!(orders.len(), 451);
        assert!(orders.iter().all(|order| order.iter().collect::<BTreeSet<_>>().len() == 1000));
        assert_eq!(orders.iter().collect::<BTreeSet<_>>().len(), 451, "an order twice could be learnt");
        assert_eq!(rounds.digest(), judged(1000));
    }

    #[test]
    fn rounds_are_joined_up_to_a_plenty() {
        for (queries, count, together) in [(5, 100_000, 200_000), (3000, 100, 201_000), (3000, 3, 9000)] {
            let mut most = 0;
            let mut rounds = Rounds::of(queries);
            time(&mut rounds, count, |order| most = most.max(order.len()));
            assert_eq!(most, together, "{queries} queries");
            assert_eq!(rounds.digest(), judged(queries));
        }
    }

    #[test]
    fn a_plenty_is_asked_as_it_is() {
        let mut rounds = Rounds::of(PLENTY);
        for _ in 0..2 {
            time(&mut rounds, 2, |order| assert!(order.is_sorted()));
        }
        assert_eq!(rounds.digest(), judged(PLENTY));
    }

    #[test]
    fn one_answer_that_changes_in_a_later_round_changes_the_digest() {
        for (queries, place) in [(1, 0), (1000, 17), (1000, 999), (PLENTY, 12_345)] {
            let mut rounds = Rounds::of(queries);
            let mut asked = 0;
            let mut pass = |rounds: &mut Rounds| {
                rounds.time(3, |order, out| {
                    asked += out.len();
                    for (at, out) in out.iter_mut().enumerate() {
                        let place_of = order.map_or(at, |order| order[at] as usize);
                        let is_last = asked > 3 * queries && place_of == place;
                        *out = if is_last { Sign::Positive } else { Sign::Negative };
                    }
                    Duration::ZERO
                });
            };
            let all = Answers(vec![Sign::Negative; queries]).digest();
            pass(&mut rounds);
            assert_eq!(rounds.digest(), all);
            pass(&mut rounds);
            assert_ne!(rounds.digest(), all, "{place} of {queries}");
        }
    }
}
