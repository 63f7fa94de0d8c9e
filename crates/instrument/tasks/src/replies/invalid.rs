//! Invalid input: a program should refuse it, and should not refuse valid input.
//!
//! A suite marks a scene by `invalid = true`, and the judge of the task confirms the flaw in rationals. A program that
//! reports an error or declines is right about such a scene. An answer is of class [`Class::Accepted`]: it has no
//! meaning, and the program did not say so. A crash and silence stay what they are.
//!
//! An error about a scene without a flaw is of class [`Class::Refused`]. A decline is different: there the engine says
//! that the library does not offer this kind of input.

use predicament_predicates::Class;

use super::Reply;
use crate::{Finding, Outcome};

/// The check of errors that a program reports.
pub const REFUSED: &str = "refused valid input";
/// The check of answers to invalid input.
pub const ACCEPTED: &str = "accepted invalid input";
/// The check of scenes that a program declines.
pub const ANSWER: &str = "answer";

/// The outcome of a backend of this project: it is not asked about invalid input.
pub(crate) fn not_asked(queries: u64, why: &str) -> Outcome {
    let reason = format!("invalid input is for programs that answer the whole task ({why})");
    Outcome::of_scene(queries, Class::Declined, "prepare", reason)
}

/// Notes that a program has answered invalid input.
pub(crate) fn accepted(reply: &Reply, why: &str, outcome: &mut Outcome) {
    outcome.digest = Some(reply.digest());
    outcome.counts.add(Class::Accepted, 1);
    let got = format!("an answer with {}", reply.arrays.names());
    outcome.findings.push(Finding::plain(Class::Accepted, ACCEPTED, Vec::new(), got, why.to_owned()));
}

/// The outcome of a program on invalid input: its refusal is right.
pub(crate) fn refused(outcome: Outcome) -> Outcome {
    let is_refusal = |finding: &Finding| finding.check == REFUSED || finding.check == ANSWER;
    if outcome.findings.is_empty() || !outcome.findings.iter().all(is_refusal) {
        return outcome;
    }
    let mut right = Outcome { queries: outcome.queries, ..Outcome::default() };
    right.counts.add(Class::Agree, outcome.queries);
    right
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refusal_of_invalid_input_is_right_and_a_crash_is_not() {
        let of = |class: Class, check: &str| {
            let outcome = refused(Outcome::of_scene(7, class, check, "no".to_owned()));
            (outcome.counts.get(Class::Agree), outcome.findings.len())
        };
        assert_eq!(of(Class::Refused, REFUSED), (7, 0));
        assert_eq!(of(Class::Declined, ANSWER), (7, 0));
        // The scene has not reached the program.
        assert_eq!(of(Class::Declined, "prepare"), (0, 1));
        assert_eq!(of(Class::Panic, "crashed"), (0, 1));
        assert_eq!(of(Class::Timeout, "silence"), (0, 1));
    }

    #[test]
    fn an_answer_to_invalid_input_is_a_finding() {
        let mut outcome = Outcome::default();
        accepted(&Reply::default(), "it crosses itself", &mut outcome);
        let finding = &outcome.findings[0];
        assert_eq!((finding.class, finding.truth.as_str()), (Class::Accepted, "it crosses itself"));
        assert_eq!(refused(outcome).counts.get(Class::Accepted), 1, "it stays one");
    }
}
