//! Predicates in plain doubles, as shown in docs/BACKENDS.md.

use predicament::predicates::{
    Axis, Backend, Contract, Declined, Plane, PredicateKind, Predicates, Scene, Sign, Tally, Vertex, ZeroMeaning,
};

pub struct Mine;

pub struct Session<'s, T> {
    scene: &'s Scene,
    tally: T,
}

impl Backend for Mine {
    type Session<'s, T: Tally + 's> = Session<'s, T>;

    fn name(&self) -> String {
        "mine".to_owned()
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: ZeroMeaning::Exact, proved: false }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["float"]
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, tally: T) -> Result<Session<'s, T>, Declined> {
        if !scene.constructions().is_empty() {
            return Err(Declined::scene("no coordinates for constructed vertices"));
        }
        Ok(Session { scene, tally })
    }
}

impl<T: Tally> Predicates for Session<'_, T> {
    fn scene(&self) -> &Scene {
        self.scene
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        match kind {
            PredicateKind::Compare | PredicateKind::Orient2d => self.scene.has_dimension_for(kind),
            other => Err(Declined::predicate(other, "not written yet")),
        }
    }

    fn compare(&self, axis: Axis, a: Vertex, b: Vertex) -> Sign {
        self.tally.settled(PredicateKind::Compare, 0); // stage 0 of `stages`
        Sign::of(self.scene.coordinate(axis, a) - self.scene.coordinate(axis, b))
    }

    fn orient2d(&self, plane: Plane, a: Vertex, b: Vertex, c: Vertex) -> Sign {
        self.tally.settled(PredicateKind::Orient2d, 0);
        let [a, b, c] = [a, b, c].map(|v| self.scene.point2(plane, v));
        Sign::of((a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]))
    }

    fn orient3d(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unreachable!("`supports` declines it")
    }

    fn incircle(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unreachable!("`supports` declines it")
    }

    fn insphere(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        unreachable!("`supports` declines it")
    }
}
