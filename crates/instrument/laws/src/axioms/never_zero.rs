//! The law of broken ties: a session that declares it never answers zero for distinct vertices.

use predicament_predicates::{Predicates, Question, Vertex, ZeroMeaning};

use super::{Answer, Law, Violation, are_distinct};

/// Finds a zero for distinct vertices, from a session that declares it never answers so.
///
/// `is_identity` is called for zeros only. It returns true if the determinant is zero however the input moves, for
/// example for a vertex and the plane that it was constructed on. Such a zero is not a tie.
pub fn never_zero<P: Predicates + ?Sized>(
    session: &P,
    question: Question,
    args: &[Vertex],
    zero: ZeroMeaning,
    is_identity: impl FnOnce(&[Vertex]) -> bool,
) -> Option<Violation> {
    if zero != ZeroMeaning::Never || !are_distinct(args) {
        return None;
    }
    let sign = question.ask(session, args);
    let broken = sign.is_zero() && !is_identity(args);
    broken.then(|| Violation { law: Law::NeverZero, answers: vec![Answer { question, args: args.to_vec(), sign }] })
}
