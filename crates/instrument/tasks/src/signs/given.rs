//! The answers to a scene, and the class of each.

use predicament_judge::{self as judge, TieJudge};
use predicament_predicates::{Band, Contract, Predicates, QuerySet, Scene, Sign};

use super::classify;
use crate::Class;

/// The answers to a scene with all that they are held against.
pub(super) struct Given<'a> {
    pub scene: &'a Scene,
    pub queries: &'a QuerySet,
    pub truth: &'a [Sign],
    pub answers: &'a [Sign],
    pub session: &'a dyn Predicates,
    pub contract: Contract,
    /// The band that the answers are held to, the published one; none where none is claimed.
    pub band: Option<Band>,
}

impl Given<'_> {
    /// The class of the answer that was given to a query.
    pub(super) fn class(&self, query: usize) -> Class {
        let question = self.queries.question();
        let (args, got, truth) = (self.queries.args(query), self.answers[query], self.truth[query]);
        // A NaN compares as zero, so only zeros can hide one.
        if got.is_zero() && self.session.estimate(question, args).is_some_and(f64::is_nan) {
            return Class::Nan;
        }
        classify(self.contract.zero, self.band, got, truth, |limit| judge::is_within(self.scene, question, args, limit))
    }
}

/// The class of the answer to a query. Where ties are broken, zero agrees with an identity.
pub(super) fn class(given: &Given<'_>, ties: Option<&TieJudge>, query: usize) -> Class {
    match given.class(query) {
        Class::Inconsistent if is_identity(given, ties, query) => Class::Agree,
        class => class,
    }
}

/// Whether a determinant is zero however the scene moves: no tie, but a vertex
/// on the plane it was constructed on, two names of one point, or vertices of
/// one mesh that is moved as a whole.
fn is_identity(given: &Given<'_>, ties: Option<&TieJudge>, query: usize) -> bool {
    let (question, args) = (given.queries.question(), given.queries.args(query));
    ties.is_some_and(|perturbed| perturbed(given.scene, question, args).is_zero())
}
