//! The three-term Grassmann-Plücker relations.
//!
//! With \[…\] the determinant of homogeneous points, and x standing for the
//! points that all six brackets share,
//!
//! \[x a b\]\[x c d\] − \[x a c\]\[x b d\] + \[x a d\]\[x b c\] = 0.
//!
//! Three numbers that add up to zero are all zero, or two of them have
//! opposite signs. An orientation predicate is a bracket up to one fixed sign,
//! which cancels in the products.

use predicament_predicates::{Plane, Predicates, Question, Sign, Vertex, ZeroMeaning};

use super::{Answer, Law, Violation, says_nothing};

/// The relation for `orient2d`: `shared` in all six triples, `others` in pairs.
pub fn grassmann_plucker2<P: Predicates>(
    session: &P,
    plane: Plane,
    shared: Vertex,
    others: [Vertex; 4],
    zero: ZeroMeaning,
) -> Option<Violation> {
    relation(session, Question::Orient2d(plane), &[shared], others, zero)
}

/// The relation for `orient3d`: `shared` in all six quadruples, `others` in pairs.
pub fn grassmann_plucker3<P: Predicates>(
    session: &P,
    shared: [Vertex; 2],
    others: [Vertex; 4],
    zero: ZeroMeaning,
) -> Option<Violation> {
    relation(session, Question::Orient3d, &shared, others, zero)
}

fn relation<P: Predicates>(
    session: &P,
    question: Question,
    shared: &[Vertex],
    [a, b, c, d]: [Vertex; 4],
    zero: ZeroMeaning,
) -> Option<Violation> {
    let answers = [[a, b], [c, d], [a, c], [b, d], [a, d], [b, c]].map(|pair| {
        let args = [shared, &pair].concat();
        let sign = question.ask(session, &args);
        Answer { args, sign }
    });
    if answers.iter().any(|answer| says_nothing(answer.sign, zero)) {
        return None;
    }
    let product = |at: usize| answers[at].sign * answers[at + 1].sign;
    let terms = [product(0), -product(2), product(4)];
    let balanced = terms.contains(&Sign::Positive) == terms.contains(&Sign::Negative);
    (!balanced).then(|| Violation { law: Law::GrassmannPlucker, question, answers: answers.into() })
}
