//! The judge's signs as a session, for algorithms that need predicates.

use predicament_predicates::{Construction, Predicates, Question, Refused, Scene, Sign, Vertex, answer_by};

use crate::Points;

/// The sign of a perturbed scene, for backends that break ties: computed in
/// another way than the backend computes it.
pub type TieJudge = dyn Fn(&Scene, Question, &[Vertex]) -> Sign + Send + Sync;

/// A session that answers with the judge's signs. It shares nothing with any
/// backend; contacts go by the trait's own bodies.
pub struct Judged<'s> {
    /// With the vertices that were constructed since.
    points: Points,
    way: Way<'s>,
}

enum Way<'s> {
    Exact,
    Again,
    Perturbed(&'s TieJudge),
}

impl<'s> Judged<'s> {
    /// Exact signs: [`judge::sign`](crate::sign).
    #[must_use]
    pub fn exact(scene: &Scene) -> Judged<'s> {
        Judged { points: Points::of(scene), way: Way::Exact }
    }

    /// Exact signs by the judge's other computation, which is slow: [`judge::verdict`](crate::verdict).
    #[must_use]
    pub fn again(scene: &Scene) -> Judged<'s> {
        Judged { points: Points::of(scene), way: Way::Again }
    }

    /// The signs of a perturbed scene. A perturbation by infinitesimals
    /// changes no sign that is not zero, so only zeros are asked about.
    #[must_use]
    pub fn perturbed(scene: &Scene, ties: &'s TieJudge) -> Judged<'s> {
        Judged { points: Points::of(scene), way: Way::Perturbed(ties) }
    }

    fn sign<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        match self.way {
            Way::Exact => self.points.sign(question, &args),
            Way::Again => self.points.verdict(question, &args).sign(),
            Way::Perturbed(ties) => match self.points.sign(question, &args) {
                Sign::Zero => ties(self.points.scene(), question, &args),
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

    answer_by!(sign);
}
