//! The law of the reference: if a reference answers a non-zero sign, the session answers the same.
//!
//! All other laws compare answers with each other. This law needs the exact answers. It states that a perturbation must
//! not change a sign that is not zero.

use predicament_predicates::{Predicates, Question, Vertex, ZeroMeaning};

use super::{Answer, Law, Violation, says_nothing};

/// Checks that the session's answer equals the reference's if that is not zero. The second answer of the violation is
/// the reference's.
pub fn equals_reference<P: Predicates + ?Sized, R: Predicates + ?Sized>(
    session: &P,
    reference: &R,
    question: Question,
    args: &[Vertex],
    zero: ZeroMeaning,
) -> Option<Violation> {
    let truth = question.ask(reference, args);
    if truth.is_zero() {
        return None;
    }
    let sign = question.ask(session, args);
    let broken = sign != truth && !says_nothing(sign, zero);
    let answer = |sign| Answer { question, args: args.to_vec(), sign };
    broken.then(|| Violation { law: Law::Reference, answers: vec![answer(sign), answer(truth)] })
}
