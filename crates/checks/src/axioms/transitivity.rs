//! The law of transitivity: comparisons along an axis are an order.

use predicament_predicates::{Axis, Predicates, Question, Sign, Vertex, ZeroMeaning};

use super::{Answer, Law, Violation, says_nothing};

/// Whether a, b and c can be put on one line: a ≤ b ≤ c implies a ≤ c, and
/// a < c if one of the two is strict.
pub fn transitivity<P: Predicates + ?Sized>(
    session: &P,
    axis: Axis,
    [a, b, c]: [Vertex; 3],
    zero: ZeroMeaning,
) -> Option<Violation> {
    let question = Question::Compare(axis);
    let answers = [[a, b], [b, c], [a, c]].map(|args| Answer {
        question,
        args: args.to_vec(),
        sign: question.ask(session, &args),
    });
    if answers.iter().any(|answer| says_nothing(answer.sign, zero)) {
        return None;
    }
    let [ab, bc, ac] = [0, 1, 2].map(|at: usize| answers[at].sign);
    let forced = match (ab, bc) {
        (Sign::Zero, other) | (other, Sign::Zero) => Some(other),
        (first, second) if first == second => Some(first),
        _ => None,
    };
    let broken = forced.is_some_and(|forced| forced != ac);
    broken.then(|| Violation { law: Law::Transitivity, answers: answers.into() })
}
