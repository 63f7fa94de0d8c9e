//! The session of a program: judges of whole answers do not query it.

use predicament_predicates::{
    Broken, Class, Declined, PredicateKind, Predicates, Question, Scene, Sign, Vertex, answer_by,
};

/// A session without predicates.
pub(super) struct Unasked<'s>(pub &'s Scene);

impl Unasked<'_> {
    fn refuse<const N: usize>(&self, question: Question, args: [Vertex; N]) -> Sign {
        let message = format!("{}: the program answers whole scenes, not single predicates", question.query(&args));
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

    answer_by!(refuse);
}
