//! A backend that orders coordinates by the sign of their difference in doubles.
//!
//! Doubles underflow gradually, so a difference is zero only if its operands are equal, and a difference that overflows
//! keeps its sign: the answers are exact.

use predicament::predicates::{
    Axis, Backend, Contract, Declined, Plane, PredicateKind, Predicates, Scene, Sign, Tally, Vertex, ZeroMeaning,
};

/// A backend that compares coordinates by subtracting them; it declines every other predicate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ByDifference;

/// The session of [`ByDifference`] for one scene.
pub struct Session<'s, T> {
    scene: &'s Scene,
    tally: T,
}

impl Backend for ByDifference {
    type Session<'s, T: Tally + 's> = Session<'s, T>;

    fn name(&self) -> String {
        "by-difference".to_owned()
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Exact, proved: true }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["difference"]
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Session<'s, T>, Declined> {
        if scene.constructions().is_empty() {
            Ok(Session { scene, tally })
        } else {
            Err(Declined::scene("constructed vertices have no coordinates to subtract"))
        }
    }
}

impl<T: Tally> Predicates for Session<'_, T> {
    fn scene(&self) -> &Scene {
        self.scene
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        match kind {
            PredicateKind::Compare => Ok(()),
            other => Err(Declined::predicate(other, "only coordinates are compared")),
        }
    }

    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        self.tally.settled(PredicateKind::Compare, 0);
        Sign::of(self.scene.coordinate(axis, a) - self.scene.coordinate(axis, b))
    }

    fn orient2d(&self, _: Plane, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        declined()
    }

    fn orient3d(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        declined()
    }

    fn incircle(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        declined()
    }

    fn insphere(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        declined()
    }
}

fn declined() -> Sign {
    unreachable!("`supports` declines this predicate")
}
