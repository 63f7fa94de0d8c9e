//! The rational backend on scenes of the corpora: it agrees with the judge, and one wrong sign in it is found.

use predicament_controls::{ExactRational, RationalSession};
use predicament_predicates::{
    Backend, Construction, Constructs, Contract, Declined, Plane, PredicateKind, Predicates, Question, Refused, Scene,
    Sign, Tally, Vertex, answer_by,
};
use predicament_tasks::{Class, Entry};

use crate::common::{judged, judged_by_name, load};

/// Scenes of input vertices, of each kind of constructed vertex, and of coordinates with exponents of their own.
const SCENES: [&str; 5] = ["kettner-a1", "kite", "kite-order", "pyramid", "wide-mixed-orient2d"];

#[test]
fn rational_signs_are_the_judge_s() {
    for name in SCENES {
        let outcome = judged_by_name(&load(name), "exact:rational");
        assert_eq!((outcome.counts.get(Class::Agree), outcome.counts.findings()), (outcome.queries, 0), "{name}");
    }
}

/// The rational backend with one wrong sign: the turn of the scene's first three vertices.
struct OneWrong;

struct Session<T>(RationalSession<T>);

impl Backend for OneWrong {
    type Session<'s, T: Tally + 's> = Session<T>;

    fn name(&self) -> String {
        "one-wrong".to_owned()
    }

    fn contract(&self, kind: PredicateKind) -> Contract {
        ExactRational.contract(kind)
    }

    fn stages(&self) -> &'static [&'static str] {
        ExactRational.stages()
    }

    fn constructs(&self) -> Constructs {
        ExactRational.constructs()
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Session<T>, Declined> {
        ExactRational.prepare(scene, tally).map(Session)
    }
}

impl<T: Tally> Session<T> {
    fn ask<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        let sign = question.ask(&self.0, &args);
        let first: Vec<Vertex> = (0..3).map(Vertex::input).collect();
        if question == Question::Orient2d(Plane::Xy) && args.as_slice() == first { -sign } else { sign }
    }
}

impl<T: Tally> Predicates for Session<T> {
    fn scene(&self) -> &Scene {
        self.0.scene()
    }

    fn construct(&mut self, definitions: &[Construction]) -> Result<Vec<Vertex>, Refused> {
        self.0.construct(definitions)
    }

    answer_by!(ask);
}

#[test]
fn one_wrong_sign_is_found() {
    for name in ["kettner-a1", "kite"] {
        let outcome = judged(&load(name), &Entry::new(OneWrong));
        assert!(outcome.counts.get(Class::SignFlip) > 0, "{name}: {:?}", outcome.counts);
    }
}
