//! A backend for examples, with comparisons and orientations in plain floating point.

use predicament_predicates::{
    Backend, Contract, Declined, PredicateKind, Predicates, Question, Scene, Sign, Tally, Vertex, ZeroMeaning,
    answer_by,
};

/// A backend with predicates in plain doubles.
pub struct Mine;

/// The session of [`Mine`] for one scene.
pub struct Session<'s>(&'s Scene);

impl Backend for Mine {
    type Session<'s, T: Tally + 's> = Session<'s>;

    fn name(&self) -> String {
        "mine".to_owned()
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Exact, proved: false }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["double"]
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, _: T) -> Result<Session<'s>, Declined> {
        if scene.constructions().is_empty() {
            Ok(Session(scene))
        } else {
            Err(Declined::scene("constructed vertices have no coordinates here"))
        }
    }
}

fn turn([ax, ay]: [f64; 2], [bx, by]: [f64; 2], [cx, cy]: [f64; 2]) -> f64 {
    (ax - cx) * (by - cy) - (ay - cy) * (bx - cx)
}

impl Session<'_> {
    fn ask<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        Sign::of(match (question, &args[..]) {
            (Question::Compare(axis), &[a, b]) => self.0.coordinate(axis, a) - self.0.coordinate(axis, b),
            (Question::Orient2d(plane), &[a, b, c]) => {
                let [a, b, c] = [a, b, c].map(|v| self.0.point2(plane, v));
                turn(a, b, c)
            }
            _ => unreachable!("`supports` refuses it"),
        })
    }
}

impl Predicates for Session<'_> {
    fn scene(&self) -> &Scene {
        self.0
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        match kind {
            PredicateKind::Compare | PredicateKind::Orient2d => self.0.has_dimension_for(kind),
            other => Err(Declined::predicate(other, "not written yet")),
        }
    }

    answer_by!(ask);
}
