//! What is said about one backend: the one rule behind every figure.
//!
//! A figure about a backend depends on that backend and the scenes alone. Errors are counted over everything that the
//! backend was asked, so each backend has its own denominator: a backend that declines what is hard shows it as "not
//! done", and takes nothing from the others. Times are compared in pairs: a ratio to the reference is over the families
//! that both were timed on, and no third backend decides which these are.

use std::collections::BTreeSet;

use predicament_records::format::{counted, percent, significant};
use predicament_records::{approximately, is_predicate, wilson};

use crate::{Class, RunDir, SummaryRow};

/// Everything that a backend was asked, by how it went.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Standing {
    /// Queries of tasks whose answers are judged one by one.
    pub answers: Answers,
    /// Scenes of tasks that ask for more than signs.
    pub scenes: Scenes,
    /// Results that no expectation lists: pairs of scene and backend.
    pub unexpected: u64,
}

/// Queries: the four shares add up to everything that was asked.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Answers {
    /// The exact answer, or a tie broken as promised.
    pub right: u64,
    /// No decision: the value is within the band.
    pub undecided: u64,
    /// A wrong answer, or none although the backend says that it is done.
    pub wrong: u64,
    /// Declined, out of time, or crashed.
    pub not_done: u64,
}

/// Whole scenes: the four shares add up to everything that was asked.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Scenes {
    /// Every law holds.
    pub held: u64,
    /// Only the rounding of output coordinates shows.
    pub rounded: u64,
    /// A law is broken.
    pub broken: u64,
    /// Declined, out of time, or crashed.
    pub not_done: u64,
}

impl Answers {
    /// All queries.
    pub fn asked(&self) -> u64 {
        self.right + self.undecided + self.wrong + self.not_done
    }
}

impl Scenes {
    /// All scenes.
    pub fn asked(&self) -> u64 {
        self.done() + self.not_done
    }

    /// The scenes that the backend answered.
    pub fn done(&self) -> u64 {
        self.held + self.rounded + self.broken
    }
}

impl Standing {
    /// Adds the result of one scene; `is_whole` says that its answer is judged as a whole.
    pub fn add(&mut self, row: &SummaryRow, is_whole: bool) {
        self.unexpected += u64::from(row.status == crate::Status::Unexpected);
        let is_undone =
            !row.has_answers() && [Class::Declined, Class::Timeout, Class::Panic].iter().any(|&of| row.count(of) > 0);
        if !is_whole {
            let answers = &mut self.answers;
            let right = row.agree + row.tie_broken;
            let counted = right + row.in_band + row.wrong();
            // Axioms are violated by further orders of the arguments, too, which were not asked for themselves.
            let asked = row.queries.max(counted - counted.saturating_sub(row.queries).min(row.inconsistent));
            let rest = asked.saturating_sub(counted);
            // Each failed check takes the place of the class of at most one query, so a query without a class is wrong where there
            // are as many failed checks. Where there are not, there is nothing to say of it, as of a simplex that meets no other.
            let is_lost = row.topology > 0 && (counted == 0 || rest <= row.topology);
            let undone = if is_undone { rest } else { 0 };
            let lost = if is_lost && !is_undone { rest } else { 0 };
            // Answers that contradict each other are not right, even where one of them is.
            let wrong = (row.wrong() + lost).min(asked - undone - row.in_band);
            answers.right += asked - undone - row.in_band - wrong;
            answers.undecided += row.in_band;
            answers.wrong += wrong;
            answers.not_done += undone;
        }
        if !is_predicate(&row.task) {
            let scenes = &mut self.scenes;
            *match row {
                _ if is_undone => &mut scenes.not_done,
                row if row.topology > 0 => &mut scenes.broken,
                row if row.panic + row.timeout + row.declined > 0 => &mut scenes.not_done,
                row if row.rounded > 0 => &mut scenes.rounded,
                _ => &mut scenes.held,
            } += 1;
        }
    }

    /// Whether there was no mistake.
    pub fn is_right(&self) -> bool {
        self.answers.wrong == 0 && self.scenes.broken == 0
    }

    /// Whether the backend decided everything that it was asked.
    pub fn is_complete(&self) -> bool {
        self.answers.undecided + self.answers.not_done + self.scenes.not_done == 0
    }
}

/// The errors of a backend, in all these runs, on the scenes for which `keep` holds.
pub fn standing(runs: &[RunDir], backend: &str, keep: impl Fn(&SummaryRow) -> bool) -> Standing {
    let whole = judged_whole(runs);
    let mut standing = Standing::default();
    let rows = runs.iter().flat_map(|run| &run.summary);
    rows.filter(|row| row.backend == backend && keep(row))
        .for_each(|row| standing.add(row, whole.contains(&*row.task)));
    standing
}

/// The tasks whose answers are judged as a whole.
pub fn judged_whole(runs: &[RunDir]) -> BTreeSet<&str> {
    runs.iter().flat_map(|run| &run.plan.judged_whole).map(String::as_str).collect()
}

/// A share with its denominator and Wilson's interval at 95 %.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Share {
    pub count: u64,
    pub of: u64,
}

impl Share {
    /// The share itself; none of nothing.
    pub fn value(self) -> Option<f64> {
        (self.of > 0).then(|| approximately(self.count) / approximately(self.of))
    }

    /// The interval.
    pub fn interval(self) -> [f64; 2] {
        wilson(self.count.min(self.of), self.of)
    }

    /// In percent, short.
    pub fn text(self) -> String {
        percent(self.count, self.of)
    }

    /// The counts and the interval: `3 of 40; 95 %: 2.6 to 19.9 %`.
    pub fn told(self, noun: &str) -> String {
        let [low, high] = self.interval().map(|share| significant(100.0 * share, 2));
        format!(
            "{} of {}; 95 %: {low} to {high} %",
            predicament_records::format::thousands(self.count),
            counted(self.of, noun)
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use predicament_records::{PlannedScene, Status};

    fn row(task: &str, counts: &[(Class, u64)]) -> SummaryRow {
        let scene = PlannedScene {
            suite: "s".to_owned(),
            scene: "a".to_owned(),
            scene_id: "0".to_owned(),
            task: task.to_owned(),
            family: "f".to_owned(),
            queries: 10,
        };
        let mut row = SummaryRow::new(&scene, "b", 10, Status::Ok);
        counts.iter().for_each(|&(class, count)| *row.count_mut(class) = count);
        row
    }

    fn of(task: &str, is_whole: bool, counts: &[(Class, u64)]) -> Standing {
        let mut standing = Standing::default();
        standing.add(&row(task, counts), is_whole);
        standing
    }

    #[test]
    fn four_shares_are_everything_that_was_asked() {
        let cases: [(&[(Class, u64)], Answers); 9] = [
            // Two queries have other answers to their arguments in another order.
            (
                &[(Class::Agree, 9), (Class::SignFlip, 1), (Class::Inconsistent, 2)],
                Answers { right: 7, wrong: 3, ..Answers::default() },
            ),
            (&[(Class::Agree, 7), (Class::TieBroken, 3)], Answers { right: 10, ..Answers::default() }),
            (&[(Class::Agree, 7), (Class::InBand, 3)], Answers { right: 7, undecided: 3, ..Answers::default() }),
            (&[(Class::Agree, 7), (Class::SignFlip, 3)], Answers { right: 7, wrong: 3, ..Answers::default() }),
            (&[(Class::Declined, 1)], Answers { not_done: 10, ..Answers::default() }),
            // What a broken law took with it is not right.
            (&[(Class::Agree, 9), (Class::Topology, 1)], Answers { right: 9, wrong: 1, ..Answers::default() }),
            (&[(Class::Topology, 1)], Answers { wrong: 10, ..Answers::default() }),
            // A law of the whole scene, beside contacts of two of ten simplices.
            (&[(Class::Agree, 2), (Class::Topology, 1)], Answers { right: 10, ..Answers::default() }),
            // Simplices that meet no other.
            (&[(Class::Agree, 2)], Answers { right: 10, ..Answers::default() }),
        ];
        for (counts, answers) in cases {
            let standing = of("polygon-locate", false, counts);
            assert_eq!((standing.answers, standing.answers.asked()), (answers, 10));
            assert_eq!(standing.scenes.asked(), 1);
        }
    }

    #[test]
    fn a_scene_is_held_rounded_broken_or_not_done() {
        let scenes = |counts: &[(Class, u64)]| of("slice", true, counts).scenes;
        assert_eq!(scenes(&[(Class::Agree, 10)]), Scenes { held: 1, ..Scenes::default() });
        assert_eq!(scenes(&[(Class::Rounded, 2)]), Scenes { rounded: 1, ..Scenes::default() });
        assert_eq!(scenes(&[(Class::Rounded, 2), (Class::Topology, 1)]), Scenes { broken: 1, ..Scenes::default() });
        assert_eq!(scenes(&[(Class::Timeout, 1)]), Scenes { not_done: 1, ..Scenes::default() });
        assert_eq!(of("slice", true, &[(Class::Topology, 1)]).answers, Answers::default());
        assert_eq!(of("orient2d", false, &[(Class::Agree, 10)]).scenes, Scenes::default());
    }
}
