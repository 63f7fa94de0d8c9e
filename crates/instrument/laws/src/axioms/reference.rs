//! The law of the reference: where a reference is not zero, the answer is the same.
//!
//! All other laws hold answers against each other. This one needs somebody who
//! knows the truth, and says what a perturbation must not do: change a sign
//! that is one.

use predicament_predicates::{Predicates, Question, Vertex, ZeroMeaning};

use super::{Answer, Law, Violation, says_nothing};

/// Where the reference is not zero, the session has to answer the same. The
/// second answer of the violation is the reference's.
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
