//! Explanation of one query: its exact value, the answer and stage of each backend, and the consistency of its answers
//! to permutations.

use predicament_judge as judge;
use predicament_predicates::{Declined, PredicateKind, Query, Question, Scene, Sign, Vertex};

use crate::{Contestant, ExplainError, Explanation};

/// Evaluates one query alone.
pub(super) fn explain(scene: &Scene, query: &Query, backends: &[&dyn Contestant]) -> Result<Explanation, ExplainError> {
    let (question, args) = query.question().ok_or_else(|| ExplainError::not_of_task(query, "asks for no sign"))?;
    scene.has_dimension_for(question.kind())?;
    let verdict = judge::verdict(scene, question, args);
    let degeneracy = judge::log2_relative(&verdict).map_or_else(|| "exactly zero".to_owned(), |x| format!("2^{x:.2}"));
    let cells = |backend: &dyn Contestant| -> Result<Vec<String>, Declined> {
        let (sign, stage) = backend.ask(scene, question, args)?;
        let mut cells = vec![sign.to_string(), stage.unwrap_or_default().to_owned()];
        backend.with_session(scene, &mut |session| {
            let band = session.band(question).map(|band| [band.lower, band.width, band.upper]);
            cells.push(session.estimate(question, args).map_or_else(String::new, |x| format!("{x:e}")));
            cells.push(band.map_or_else(String::new, |band| band.map(|x| format!("{x:e}")).join(", ")));
        })?;
        Ok(cells)
    };
    let row = |&backend: &&dyn Contestant| (backend.name(), cells(backend).unwrap_or_else(|why| vec![why.to_string()]));
    Ok(Explanation {
        vertices: args.to_vec(),
        truth: vec![format!("exact sign {}, |det| / permanent {degeneracy}", verdict.sign())],
        heads: ["sign", "stage", "estimate", "band (lower, width, upper)"].map(str::to_owned).to_vec(),
        rows: backends.iter().map(row).collect(),
        permutations: permuted(scene, question, args, backends),
    })
}

/// The signs of all permutations by the truth and by each backend that answers, negated for odd permutations.
fn permuted(
    scene: &Scene,
    question: Question,
    args: &[Vertex],
    backends: &[&dyn Contestant],
) -> Vec<(String, Vec<Sign>)> {
    let orders = orders(question.kind());
    let asked: Vec<Vertex> = orders.iter().flat_map(|(order, _)| order.iter().map(|&at| args[at])).collect();
    let turned = |signs: &[Sign]| -> Vec<Sign> {
        signs.iter().zip(&orders).map(|(&sign, &(_, is_odd))| if is_odd { -sign } else { sign }).collect()
    };
    let exact = asked.chunks(args.len()).map(|args| judge::verdict(scene, question, args).sign());
    let mut rows = vec![("exact sign".to_owned(), turned(&exact.collect::<Vec<Sign>>()))];
    for backend in backends {
        let mut told = None;
        let prepared = backend.with_session(scene, &mut |session| {
            if session.supports(question.kind()).is_ok() {
                let mut signs = vec![Sign::Zero; orders.len()];
                question.ask_batch(session, &asked, &mut signs);
                told = Some(turned(&signs));
            }
        });
        // A backend that declines is already in the rows.
        rows.extend(prepared.ok().and(told).map(|signs| (backend.name(), signs)));
    }
    rows
}

/// The orders of a predicate's arguments, each with true if it turns the sign.
fn orders(kind: PredicateKind) -> Vec<(Vec<usize>, bool)> {
    let PredicateKind::Derived(derived) = kind else { return permutations(kind.arity()) };
    let given = (0..kind.arity()).collect();
    let swaps = derived.formula().swaps().iter().map(|swap| (swap.to.clone(), swap.turns));
    std::iter::once((given, false)).chain(swaps).collect()
}

/// All permutations of `count` indices, in lexicographic order, each with true if it is odd.
fn permutations(count: usize) -> Vec<(Vec<usize>, bool)> {
    if count == 0 {
        return vec![(Vec::new(), false)];
    }
    let of_rest = permutations(count - 1);
    let first = |first: usize| {
        of_rest.iter().map(move |(rest, is_odd)| {
            let rest = rest.iter().map(|&at| at + usize::from(at >= first));
            (std::iter::once(first).chain(rest).collect(), is_odd ^ (first % 2 == 1))
        })
    };
    (0..count).flat_map(first).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn permutations_are_in_order_and_half_of_them_are_odd() {
        for (count, all) in [(1, 1), (2, 2), (3, 6), (4, 24), (5, 120)] {
            let orders = permutations(count);
            assert_eq!(orders.len(), all);
            assert!(orders.is_sorted_by(|a, b| a.0 < b.0));
            for (order, is_odd) in orders {
                let inversions =
                    (0..count).flat_map(|j| (0..j).map(move |i| (i, j))).filter(|&(i, j)| order[i] > order[j]);
                assert_eq!(inversions.count() % 2 == 1, is_odd, "{order:?}");
            }
        }
    }
}
