//! The law of antisymmetry: an odd permutation of the arguments changes the sign.

use predicament_predicates::{Predicates, Question, Sign, Vertex, ZeroMeaning};

use super::{Answer, Law, Violation, says_nothing};

/// Asks one query in every order of its arguments.
///
/// All five predicates are signs of determinants with one row (or, for the
/// comparison, one term) per vertex, so an odd permutation flips the sign. The
/// violations come in pairs: the first order whose answer says something, and
/// one that contradicts it.
///
/// # Panics
/// If `args` has not exactly as many vertices as the predicate takes.
pub fn antisymmetry<P: Predicates + ?Sized>(
    session: &P,
    question: Question,
    args: &[Vertex],
    zero: ZeroMeaning,
) -> Vec<Violation> {
    let mut reference: Option<(Answer, Sign)> = None;
    let mut violations = Vec::new();
    each_order(args, &mut |args, parity| {
        let sign = question.ask(session, args);
        if says_nothing(sign, zero) {
            return;
        }
        // Vectors are made for the first answer and for violations only.
        match &reference {
            None => reference = Some((Answer { question, args: args.to_vec(), sign }, sign * parity)),
            Some((first, even)) if sign * parity != *even => {
                let answers = vec![first.clone(), Answer { question, args: args.to_vec(), sign }];
                violations.push(Violation { law: Law::Antisymmetry, answers });
            }
            Some(_) => {}
        }
    });
    violations
}

/// Calls `visit` with every permutation of `items` and its parity, the given
/// order first.
pub fn each_order(items: &[Vertex], visit: &mut impl FnMut(&[Vertex], Sign)) {
    fn place(items: &mut [Vertex], at: usize, parity: Sign, visit: &mut impl FnMut(&[Vertex], Sign)) {
        if at == items.len() {
            return visit(items, parity);
        }
        for chosen in at..items.len() {
            items.swap(at, chosen);
            place(items, at + 1, if chosen == at { parity } else { -parity }, visit);
            items.swap(at, chosen);
        }
    }
    place(&mut items.to_vec(), 0, Sign::Positive, visit);
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_order_comes_once_with_the_parity_of_its_inversions() {
        let items: Vec<Vertex> = (0..5).map(Vertex::input).collect();
        let mut seen = BTreeSet::new();
        each_order(&items, &mut |order, parity| {
            let inversions = (0..5).flat_map(|i| (i..5).filter(move |&j| order[i] > order[j])).count();
            assert_eq!(parity, if inversions % 2 == 0 { Sign::Positive } else { Sign::Negative });
            assert!(seen.insert(order.to_vec()));
        });
        assert_eq!(seen.len(), 120);
    }
}
