//! The judge as a session: what algorithms make of true signs.

use predicament_predicates::{Axis, Construction, Plane, Predicates, Question, Refused, Scene, Sign, Vertex};

use crate::{point, sign, verdict};

/// The sign of a perturbed scene, for backends that break ties: computed in
/// another way than the backend computes it.
pub type TieJudge = dyn Fn(&Scene, Question, &[Vertex]) -> Sign + Sync;

/// A session that answers with the judge's signs. It shares nothing with any
/// backend; contacts go by the trait's own bodies.
pub struct Judged<'s> {
    /// With the vertices that were constructed since.
    scene: Scene,
    way: Way<'s>,
}

enum Way<'s> {
    Exact,
    Again,
    Perturbed(&'s TieJudge),
}

impl<'s> Judged<'s> {
    /// Exact signs: [`judge::sign`](sign).
    #[must_use]
    pub fn exact(scene: &Scene) -> Judged<'s> {
        Judged { scene: scene.clone(), way: Way::Exact }
    }

    /// Exact signs by the judge's other computation, which is slow: [`judge::verdict`](verdict).
    #[must_use]
    pub fn again(scene: &Scene) -> Judged<'s> {
        Judged { scene: scene.clone(), way: Way::Again }
    }

    /// The signs of a perturbed scene. A perturbation by infinitesimals
    /// changes no sign that is not zero, so only zeros are asked about.
    #[must_use]
    pub fn perturbed(scene: &Scene, ties: &'s TieJudge) -> Judged<'s> {
        Judged { scene: scene.clone(), way: Way::Perturbed(ties) }
    }

    fn sign(&self, question: Question, args: &[Vertex]) -> Sign {
        match self.way {
            Way::Exact => sign(&self.scene, question, args),
            Way::Again => verdict(&self.scene, question, args).sign(),
            Way::Perturbed(ties) => match sign(&self.scene, question, args) {
                Sign::Zero => ties(&self.scene, question, args),
                sign => sign,
            },
        }
    }
}

impl Predicates for Judged<'_> {
    fn scene(&self) -> &Scene {
        &self.scene
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        self.scene.construct_all(definitions, |scene, vertex| match point(scene, vertex) {
            Some(_) => Ok(()),
            None => Err("its lines and planes meet in no single point".to_owned()),
        })
    }

    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        self.sign(Question::Compare(axis), &[a, b])
    }

    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        self.sign(Question::Orient2d(plane), &[a, b, c])
    }

    fn orient3d(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.sign(Question::Orient3d, &[a, b, c, d])
    }

    fn incircle(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> Sign {
        self.sign(Question::Incircle, &[a, b, c, d])
    }

    fn insphere(&self, a: Vertex, b: Vertex, c: Vertex, d: Vertex, e: Vertex) -> Sign {
        self.sign(Question::Insphere, &[a, b, c, d, e])
    }
}
