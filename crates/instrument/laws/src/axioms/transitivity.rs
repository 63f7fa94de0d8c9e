//! The law of transitivity: comparisons along an axis are an order.

use predicament_predicates::{Axis, Predicates, Question, Sign, Vertex, ZeroMeaning};

use super::{Answer, Law, Violation, says_nothing};

/// Checks that the order of a, b and c is transitive: a ≤ b ≤ c implies a ≤ c, and a < c if one of the two is strict.
pub fn transitivity<P: Predicates + ?Sized>(
    session: &P,
    axis: Axis,
    triple: [Vertex; 3],
    zero: ZeroMeaning,
) -> Option<Violation> {
    let question = Question::Compare(axis);
    violation(question, triple, pairs(triple).map(|pair| question.ask(session, &pair)), zero)
}

/// Checks [`transitivity`] of several triples in one batch.
pub fn transitivity_of_all<P: Predicates + ?Sized>(
    session: &P,
    axis: Axis,
    triples: &[[Vertex; 3]],
    zero: ZeroMeaning,
) -> Vec<Option<Violation>> {
    let asked: Vec<[Vertex; 2]> = triples.iter().flat_map(|&triple| pairs(triple)).collect();
    let mut signs = vec![Sign::Zero; asked.len()];
    session.compare_batch(axis, &asked, &mut signs);
    let question = Question::Compare(axis);
    triples.iter().zip(signs.as_chunks().0).map(|(&triple, &signs)| violation(question, triple, signs, zero)).collect()
}

/// The pairs that are compared.
fn pairs([a, b, c]: [Vertex; 3]) -> [[Vertex; 2]; 3] {
    [[a, b], [b, c], [a, c]]
}

/// The violation among the signs of the three pairs.
fn violation(question: Question, triple: [Vertex; 3], signs: [Sign; 3], zero: ZeroMeaning) -> Option<Violation> {
    if signs.into_iter().any(|sign| says_nothing(sign, zero)) {
        return None;
    }
    let [ab, bc, ac] = signs;
    let forced = match (ab, bc) {
        (Sign::Zero, other) | (other, Sign::Zero) => Some(other),
        (first, second) if first == second => Some(first),
        _ => None,
    };
    let answer = |(pair, sign): ([Vertex; 2], Sign)| Answer { question, args: pair.to_vec(), sign };
    let is_broken = forced.is_some_and(|forced| forced != ac);
    is_broken.then(|| Violation {
        law: Law::Transitivity,
        answers: pairs(triple).into_iter().zip(signs).map(answer).collect(),
    })
}
