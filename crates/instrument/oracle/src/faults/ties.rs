//! Faults in breaking ties: correct terms combined wrongly.

use predicament_predicates::{Predicates, Question, Sign, Vertex};
use predicament_sos::{Scheme, Term, ties};

use super::{Fault, colliding};

/// The sign for a query whose determinant is zero.
pub(super) fn break_tie<P: Predicates, const N: usize>(
    fault: Fault,
    exact: &P,
    question: Question,
    args: [Vertex; N],
) -> Sign {
    let Some(sorted) = ties::Sorted::new(args) else { return Sign::Zero };
    let terms = Scheme::PerCoordinate.terms(question.kind());
    let decide = |terms: &[Term], rows: &[Vertex]| ties::decide(exact, question, terms, rows);
    let decided = match fault {
        Fault::SosSwappedTerm => {
            decide(&with_swapped(terms, 2), &sorted.vertices).map(|(sign, _)| sign * sorted.parity)
        }
        Fault::SosLateSwappedTerm => {
            let late = sorted.vertices.iter().all(|v| 2 * v.index() >= exact.scene().len());
            let terms = if late { with_swapped(terms, 0) } else { terms.to_vec() };
            decide(&terms, &sorted.vertices).map(|(sign, _)| sign * sorted.parity)
        }
        Fault::SosMixedOrders => {
            let scheme = match question {
                lifted if lifted.kind().is_lifted() => Scheme::EdelsbrunnerMucke,
                _ => Scheme::PerCoordinate,
            };
            decide(scheme.terms(question.kind()), &sorted.vertices).map(|(sign, _)| sign * sorted.parity)
        }
        Fault::SosDroppedParity => decide(terms, &sorted.vertices).map(|(sign, _)| sign),
        Fault::SosDroppedLastParity => decide(terms, &sorted.vertices)
            .map(|(sign, place)| if place + 1 == terms.len() { sign } else { sign * sorted.parity }),
        Fault::SosCircularTies => match (question, args.as_slice()) {
            (Question::Compare(_), &[a, b]) => Some(in_circle(a, b)),
            _ => decide(terms, &sorted.vertices).map(|(sign, _)| sign * sorted.parity),
        },
        Fault::SosPlaceAsIdentity => decide(terms, &args).map(|(sign, _)| sign),
        Fault::SosFirstOrderOnly | Fault::SosFirstOrderThenParity => {
            // A term that moves one coordinate keeps all rows but one.
            let first: Vec<Term> = terms.iter().filter(|term| term.rows.len() + 1 == N).copied().collect();
            let decided = decide(&first, &sorted.vertices).map(|(sign, _)| sign);
            let last = (fault == Fault::SosFirstOrderThenParity).then_some(Sign::Positive);
            decided.or(last).map(|sign| sign * sorted.parity)
        }
        Fault::SosCollidingLift => match question {
            Question::Incircle => colliding::decide(exact.scene(), &sorted.vertices).map(|sign| sign * sorted.parity),
            // Without a lift all terms have different powers, and spheres have too many terms to write out.
            _ => decide(terms, &sorted.vertices).map(|(sign, _)| sign * sorted.parity),
        },
        _ => decide(terms, &sorted.vertices).map(|(sign, _)| sign * sorted.parity),
    };
    decided.unwrap_or(Sign::Zero)
}

/// The terms with the sign of the term at `place` negated, if there is such a term.
fn with_swapped(terms: &[Term], place: usize) -> Vec<Term> {
    let mut terms = terms.to_vec();
    if let Some(term) = terms.get_mut(place) {
        term.sign = -term.sign;
    }
    terms
}

/// The cyclic order by index modulo 3: each vertex is before the next, and the third before the first. Vertices with
/// equal remainders are in order.
fn in_circle(a: Vertex, b: Vertex) -> Sign {
    let [place, other] = [a, b].map(|v| v.index() % 3);
    match (place + 3 - other) % 3 {
        0 => Sign::from(a.index().cmp(&b.index())),
        1 => Sign::Positive,
        _ => Sign::Negative,
    }
}
