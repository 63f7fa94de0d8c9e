//! The rule for every figure about one backend.
//!
//! A figure about a backend depends only on that backend and the scenes. Errors are counted over everything that the
//! backend was asked, so each backend has its own denominator. A backend that declines hard scenes has them as "not
//! done", and does not affect other backends. Times are compared in pairs: a ratio to the reference covers the families
//! that both were timed on, and does not depend on a third backend.

use std::collections::BTreeSet;

use predicament_records::format::{counted, percent, significant};
use predicament_records::{approximately, is_predicate, wilson};

use crate::{Class, RunDir, SummaryRow};

/// The results of everything that a backend was asked.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Standing {
    /// The queries of tasks whose answers are judged one by one.
    pub answers: Answers,
    /// The scenes of tasks that ask for more than signs.
    pub scenes: Scenes,
    /// The number of results without an expectation: pairs of scene and backend.
    pub unexpected: u64,
}

/// The numbers of queries by result; their sum is the number of all queries.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Answers {
    /// Exact answers, and ties broken as promised.
    pub right: u64,
    /// Queries without a decision: the value is within the band.
    pub undecided: u64,
    /// Wrong answers, and missing answers of a backend that claims to be done.
    pub wrong: u64,
    /// Queries that were declined, out of time, or crashed.
    pub not_done: u64,
}

/// The numbers of whole scenes by result; their sum is the number of all scenes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Scenes {
    /// Scenes in which every law holds.
    pub held: u64,
    /// Scenes in which only the rounding of output coordinates breaks a law.
    pub rounded: u64,
    /// Scenes with a broken law.
    pub broken: u64,
    /// Scenes that were declined, out of time, or crashed.
    pub not_done: u64,
}

impl Answers {
    /// The number of all queries.
    pub fn asked(&self) -> u64 {
        self.right + self.undecided + self.wrong + self.not_done
    }
}

impl Scenes {
    /// The number of all scenes.
    pub fn asked(&self) -> u64 {
        self.done() + self.not_done
    }

    /// The number of scenes that the backend answered.
    pub fn done(&self) -> u64 {
        self.held + self.rounded + self.broken
    }
}

impl Standing {
    /// Adds the result of one scene; `is_whole` is true if its answer is judged as a whole.
    pub fn add(&mut self, row: &SummaryRow, is_whole: bool) {
        self.unexpected += u64::from(row.status == crate::Status::Unexpected);
        let undone = [Class::Declined, Class::Timeout, Class::Panic, Class::Refused];
        let is_undone = !row.has_answers() && undone.iter().any(|&of| row.count(of) > 0);
        if !is_whole {
            let answers = &mut self.answers;
            let right = row.agree + row.tie_broken;
            let counted = right + row.in_band + row.wrong();
            // Permuted arguments are additional queries, which can violate axioms too.
            let asked = row.queries.max(counted - counted.saturating_sub(row.queries).min(row.inconsistent));
            let rest = asked.saturating_sub(counted);
            // Each failed check replaces the class of at most one query. So if there are at least as many failed checks
            // as queries without a class, these queries are wrong. Otherwise nothing is known about them, as about a
            // simplex that meets no other.
            let is_lost = row.topology > 0 && (counted == 0 || rest <= row.topology);
            let undone = if is_undone { rest } else { 0 };
            let lost = if is_lost && !is_undone { rest } else { 0 };
            // Contradictory answers are wrong, even if one of them is right.
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
                // An answer to invalid input has no meaning.
                row if row.topology + row.accepted > 0 => &mut scenes.broken,
                row if undone.iter().any(|&of| row.count(of) > 0) => &mut scenes.not_done,
                row if row.rounded > 0 => &mut scenes.rounded,
                _ => &mut scenes.held,
            } += 1;
        }
    }

    /// True if there was no error.
    pub fn is_right(&self) -> bool {
        self.answers.wrong == 0 && self.scenes.broken == 0
    }

    /// True if the backend decided everything that it was asked.
    pub fn is_complete(&self) -> bool {
        self.answers.undecided + self.answers.not_done + self.scenes.not_done == 0
    }
}

/// The results of a backend in all these runs, on the scenes for which `keep` is true.
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

/// A share: a count, its denominator, and Wilson's interval at 95 %.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Share {
    pub count: u64,
    pub of: u64,
}

impl Share {
    /// The share as a number; `None` if the denominator is 0.
    pub fn value(self) -> Option<f64> {
        (self.of > 0).then(|| approximately(self.count) / approximately(self.of))
    }

    /// Wilson's interval.
    pub fn interval(self) -> [f64; 2] {
        wilson(self.count.min(self.of), self.of)
    }

    /// The share in percent, short.
    pub fn text(self) -> String {
        percent(self.count, self.of)
    }

    /// The counts and the interval in words: `3 of 40; 95 %: 2.6 to 19.9 %`.
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
            // Two queries have other answers for permuted arguments.
            (
                &[(Class::Agree, 9), (Class::SignFlip, 1), (Class::Inconsistent, 2)],
                Answers { right: 7, wrong: 3, ..Answers::default() },
            ),
            (&[(Class::Agree, 7), (Class::TieBroken, 3)], Answers { right: 10, ..Answers::default() }),
            (&[(Class::Agree, 7), (Class::InBand, 3)], Answers { right: 7, undecided: 3, ..Answers::default() }),
            (&[(Class::Agree, 7), (Class::SignFlip, 3)], Answers { right: 7, wrong: 3, ..Answers::default() }),
            (&[(Class::Declined, 1)], Answers { not_done: 10, ..Answers::default() }),
            // Queries without an answer because of a broken law are not right.
            (&[(Class::Agree, 9), (Class::Topology, 1)], Answers { right: 9, wrong: 1, ..Answers::default() }),
            (&[(Class::Topology, 1)], Answers { wrong: 10, ..Answers::default() }),
            // A broken law of the whole scene, besides contacts of two of ten simplices.
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
