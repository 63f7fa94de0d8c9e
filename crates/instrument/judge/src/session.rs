//! Sessions that answer with the judge's signs, for algorithms that need predicates.

use predicament_predicates::{
    Construction, Declined, Derived, PredicateKind, Predicates, Question, Refused, Scene, Sign, Vertex, answer_by,
};

use crate::Points;

/// The sign of a query in a perturbed scene, for backends that break ties. It is computed in another way than the
/// backend computes it.
pub type TieJudge = dyn Fn(&Scene, Question, &[Vertex]) -> Sign + Send + Sync;

/// A session that answers with the judge's signs. It shares no code with any backend; contacts use the trait's default
/// methods.
pub struct Judged<'s> {
    /// The judge of the scene, including vertices that were constructed during the session.
    points: Points,
    way: Way<'s>,
}

enum Way<'s> {
    Exact,
    Again,
    Perturbed(&'s TieJudge),
}

impl<'s> Judged<'s> {
    /// A session with exact signs: [`judge::sign`](crate::sign).
    #[must_use]
    pub fn exact(scene: &Scene) -> Judged<'s> {
        Judged { points: Points::of(scene), way: Way::Exact }
    }

    /// A session with exact signs from the judge's other, slow computation: [`judge::verdict`](crate::verdict).
    #[must_use]
    pub fn again(scene: &Scene) -> Judged<'s> {
        Judged { points: Points::of(scene), way: Way::Again }
    }

    /// A session with the signs of a perturbed scene. A perturbation by infinitesimals changes only zero signs, so only
    /// zeros are passed to `ties`.
    #[must_use]
    pub fn perturbed(scene: &Scene, ties: &'s TieJudge) -> Judged<'s> {
        Judged { points: Points::of(scene), way: Way::Perturbed(ties) }
    }

    fn ask<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        self.answer(question, &args)
    }

    fn answer(&self, question: Question, args: &[Vertex]) -> Sign {
        match self.way {
            Way::Exact => self.points.sign(question, args),
            Way::Again => self.points.verdict(question, args).sign(),
            Way::Perturbed(ties) => match self.points.sign(question, args) {
                Sign::Zero => ties(self.points.scene(), question, args),
                sign => sign,
            },
        }
    }
}

impl Predicates for Judged<'_> {
    fn scene(&self) -> &Scene {
        self.points.scene()
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        self.points.construct(definitions)
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        self.scene().has_dimension_for(kind)
    }

    fn sign(&self, predicate: Derived, vertices: &[Vertex]) -> Sign {
        self.answer(Question::Derived(predicate), vertices)
    }

    answer_by!(ask);
}
