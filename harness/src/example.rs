//! A backend for examples, with comparisons and orientations in plain floating point.

use predicament_predicates::{
    Axis, Backend, Contract, Declined, Plane, PredicateKind, Predicates, Scene, Sign, Tally, Vertex, ZeroMeaning,
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

    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        Sign::of(self.0.coordinate(axis, a) - self.0.coordinate(axis, b))
    }

    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        let [a, b, c] = [a, b, c].map(|v| self.0.point2(plane, v));
        Sign::of(turn(a, b, c))
    }

    fn orient3d(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unimplemented_predicate()
    }

    fn incircle(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unimplemented_predicate()
    }

    fn insphere(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unimplemented_predicate()
    }
}

fn unimplemented_predicate() -> Sign {
    unreachable!("`supports` refuses it")
}
