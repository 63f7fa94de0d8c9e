//! The session of a program: judges of whole answers do not query it.

use predicament_predicates::{Axis, Broken, Class, Declined, Plane, PredicateKind, Predicates, Scene, Sign, Vertex};

/// A session without predicates.
pub(super) struct Unasked<'s>(pub &'s Scene);

impl Unasked<'_> {
    fn refuse(&self) -> ! {
        let message = "the program answers whole scenes, not single predicates".to_owned();
        Broken { class: Class::Declined, check: "query", message }.throw()
    }
}

impl Predicates for Unasked<'_> {
    fn scene(&self) -> &Scene {
        self.0
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        Err(Declined::predicate(kind, "the program answers whole scenes"))
    }

    fn compare(&self, _: Axis, _: Vertex, _: Vertex) -> Sign {
        self.refuse()
    }

    fn orient2d(&self, _: Plane, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        self.refuse()
    }

    fn orient3d(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        self.refuse()
    }

    fn incircle(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        self.refuse()
    }

    fn insphere(&self, _: Vertex, _: Vertex, _: Vertex, _: Vertex, _: Vertex) -> Sign {
        self.refuse()
    }
}
